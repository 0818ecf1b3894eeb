// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_partners.hpp"

namespace scanbed {
namespace {

constexpr float kNearPartner_m = 0.35F;  // standing
constexpr float kFarPartner_m = 0.8F;    // in a stride

struct Partners {
  Floats near = Floats{} + LegPartnerReader::kUnlikely;
  Floats far = near;
  Floats rival = near;
};

[[gnu::always_inline]] inline void look_around_in(const LegPartnerReader::Likely& likely, const LegPlace& own,
                                                  Partners& found) {
  Partners best;
  const Floats none = best.near;
  Ints first, last;
  Floats x_m, y_m, sum;
  for (std::size_t i = 0; i < likely.sum.size(); i += kNumLanes) {
    load(likely.first.data() + i, first);
    load(likely.last.data() + i, last);
    load(likely.x_m.data() + i, x_m);
    load(likely.y_m.data() + i, y_m);
    load(likely.sum.data() + i, sum);
    const Ints overlaps = (first <= own.beams.last) & (last >= own.beams.first);
    const Ints is_own = (first == own.beams.first) & (last == own.beams.last);
    const Floats dx_m = x_m - own.x_m;
    const Floats dy_m = y_m - own.y_m;
    const Floats distance_m2 = dx_m * dx_m + dy_m * dy_m;
    raise(best.near, (distance_m2 < kNearPartner_m * kNearPartner_m) & ~overlaps ? sum : none);
    raise(best.far, (distance_m2 < kFarPartner_m * kFarPartner_m) & ~overlaps ? sum : none);
    raise(best.rival, overlaps & ~is_own ? sum : none);
  }
  found = best;
}

#if defined(SCANBED_HAS_AVX2)
SCANBED_AVX2 void look_around_avx2(const LegPartnerReader::Likely& likely, const LegPlace& own,
                                   Partners& found) {
  look_around_in(likely, own, found);
}
#endif

void look_around(InstructionSet set, const LegPartnerReader::Likely& likely, const LegPlace& own,
                 Partners& found) {
#if defined(SCANBED_HAS_AVX2)
  if (set == InstructionSet::kAvx2) return look_around_avx2(likely, own, found);
#endif
  look_around_in(likely, own, found);
}

}  // namespace

void LegPartnerReader::gather(std::span<const LegPlace> places, std::span<const float> sums) {
  likely_.first.clear();
  likely_.last.clear();
  for (std::vector<float>* values : {&likely_.x_m, &likely_.y_m, &likely_.sum}) values->clear();
  const auto add = [&](const LegPlace& place, float sum) {
    likely_.first.push_back(place.beams.first);
    likely_.last.push_back(place.beams.last);
    likely_.x_m.push_back(place.x_m);
    likely_.y_m.push_back(place.y_m);
    likely_.sum.push_back(sum);
  };
  for (std::size_t c = 0; c < places.size(); ++c) {
    if (sums[c] > kUnlikely) add(places[c], sums[c]);
  }
  while (likely_.sum.size() % kNumLanes != 0) add({}, kUnlikely);
}

void LegPartnerReader::read(std::span<const LegPlace> places, std::span<const float> sums,
                            LegFeatureTable& table) {
  gather(places, sums);
  Partners found;
  for (int c = 0; c < static_cast<int>(places.size()); ++c) {
    look_around(instructions_, likely_, places[c], found);
    table.at(static_cast<int>(LegFeature::kPartner35), c) = greatest_of(found.near);
    table.at(static_cast<int>(LegFeature::kPartner80), c) = greatest_of(found.far);
    table.at(static_cast<int>(LegFeature::kRival), c) = greatest_of(found.rival);
  }
}

}  // namespace scanbed
