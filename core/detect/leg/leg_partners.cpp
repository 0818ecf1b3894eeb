// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_partners.hpp"

namespace scanbed {
namespace {

constexpr float kNearPartner_m = 0.35F;  // standing
constexpr float kFarPartner_m = 0.8F;    // in a stride

/// Greatest sums around each candidate of a block.
struct Partners {
  Floats near = Floats{} + LegPartnerReader::kUnlikely;
  Floats far = near;
  Floats rival = near;
};

using Likely = LegPartnerReader::Likely;

[[gnu::always_inline]] inline void look_around_in(std::span<const Likely> likely, const LegPlaceLanes& own,
                                                  Partners& found) {
  Partners best;
  const Floats none = best.near;
  for (const Likely& other : likely) {
    const BeamSpan& beams = other.place.beams;
    const Ints overlaps = (own.first <= beams.last) & (own.last >= beams.first);
    const Ints is_own = (own.first == beams.first) & (own.last == beams.last);
    const Floats dx_m = own.x_m - other.place.x_m;
    const Floats dy_m = own.y_m - other.place.y_m;
    const Floats distance_m2 = dx_m * dx_m + dy_m * dy_m;
    const Floats sum = Floats{} + other.sum;
    raise(best.near, (distance_m2 < kNearPartner_m * kNearPartner_m) & ~overlaps ? sum : none);
    raise(best.far, (distance_m2 < kFarPartner_m * kFarPartner_m) & ~overlaps ? sum : none);
    raise(best.rival, overlaps & ~is_own ? sum : none);
  }
  found = best;
}

#if defined(SCANBED_HAS_AVX2)
SCANBED_AVX2 void look_around_avx2(std::span<const Likely> likely, const LegPlaceLanes& own,
                                   Partners& found) {
  look_around_in(likely, own, found);
}
#endif

void look_around(InstructionSet set, std::span<const Likely> likely, const LegPlaceLanes& own,
                 Partners& found) {
#if defined(SCANBED_HAS_AVX2)
  if (set == InstructionSet::kAvx2) return look_around_avx2(likely, own, found);
#endif
  look_around_in(likely, own, found);
}

}  // namespace

// Without a jump, as nothing foretells who is likely.
std::span<const Likely> LegPartnerReader::gather(std::span<const LegPlace> places,
                                                 std::span<const float> sums) {
  if (likely_.size() < places.size()) likely_.resize(places.size());
  std::size_t num_likely = 0;
  for (std::size_t c = 0; c < places.size(); ++c) {
    likely_[num_likely] = {places[c], sums[c]};
    num_likely += sums[c] > kUnlikely ? 1 : 0;
  }
  return std::span(likely_).first(num_likely);
}

void LegPartnerReader::read(std::span<const LegPlace> places, std::span<const float> sums,
                            LegFeatureTable& table) {
  const std::span<const Likely> likely = gather(places, sums);
  LegPlaceLanes own;
  Partners found;
  for (int i = 0; i < table.num_blocks(); ++i) {
    own.read(places.subspan(static_cast<std::size_t>(i) * kNumLanes));
    look_around(instructions_, likely, own, found);
    table.write(LegFeature::kPartner35, i, found.near);
    table.write(LegFeature::kPartner80, i, found.far);
    table.write(LegFeature::kRival, i, found.rival);
  }
}

}  // namespace scanbed
