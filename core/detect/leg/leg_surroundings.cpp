// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_surroundings.hpp"

#include <limits>

namespace scanbed {
namespace {

constexpr float kNearReach_m2 = LegSurroundings::kNearReach_m * LegSurroundings::kNearReach_m;
constexpr float kSmallReach_m = 1.0F;
constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();

/// Beams on either side of a candidate, in blocks that hold none of its own: from the lowest on to those that
/// end before it, then from the one behind it on. One loop goes through both sides, since where a loop ends
/// cannot be foretold. The outermost blocks may reach farther than asked for.
class Sides {
 public:
  Sides(const BeamSpan& own, const BeamSpan& all)
      : own_(own),
        num_left_(num_blocks_of(own.first - all.first)),
        num_blocks_(num_left_ + num_blocks_of(all.last - own.last)) {}

  int num_blocks() const { return num_blocks_; }
  /// Of the first block, and of the block behind another.
  int first_beam() const { return behind_own(own_.first - kNumLanes * num_left_); }
  int next_beam(int first_beam) const { return behind_own(first_beam + kNumLanes); }

 private:
  static int num_blocks_of(int num_beams) { return (num_beams + kNumLanes - 1) / kNumLanes; }
  // By where it stands rather than by its number, or the compiler makes two loops of one.
  int behind_own(int beam) const { return beam == own_.first ? own_.last + 1 : beam; }

  BeamSpan own_;
  int num_left_;
  int num_blocks_;
};

// Beams beyond those asked for are out of reach.
[[gnu::always_inline]] inline NearEchoes count_near_in(const LegView& view, const BeamSpan& all) {
  const Sides sides(view.own.beams, all);
  Ints within30{}, within50{}, within100{}, wall100{};
  Floats nearest_m2 = Floats{} + kNearReach_m2;
  Floats nearest_wall_m2 = nearest_m2;
  Floats x, y, off_wall;
  int first = sides.first_beam();
  for (int i = 0; i < sides.num_blocks(); ++i, first = sides.next_beam(first)) {
    load(view.around.x_m.from(first), x);
    load(view.around.y_m.from(first), y);
    load(view.around.off_wall_m2.from(first), off_wall);
    const Floats dx = x - view.own.x_m;
    const Floats dy = y - view.own.y_m;
    const Floats d2 = dx * dx + dy * dy;
    const Floats wall2 = d2 + off_wall;
    within30 -= d2 < 0.09F;
    within50 -= d2 < 0.25F;
    within100 -= d2 < kNearReach_m2;
    wall100 -= wall2 < kNearReach_m2;
    lower(nearest_m2, d2);
    lower(nearest_wall_m2, wall2);
  }
  const SumsOfFour sums = sums_of(within30, within50, within100, wall100);
  const LeastOfTwo least_m2 = least_of(nearest_m2, nearest_wall_m2);
  return {sums.first, sums.second, sums.third, sums.fourth, least_m2.first, least_m2.second};
}

[[gnu::always_inline]] inline BesideBeams look_beside_in(const LegView& view, const BeamSpan& all) {
  constexpr Ints kLane{0, 1, 2, 3, 4, 5, 6, 7};
  const Sides sides(view.own.beams, all);
  Ints open25{}, open60{}, hidden{};
  Floats range_m;
  const Floats none{};
  const Floats most = none + LegSurroundings::kMaxJump_m;
  Floats nearest_m = most;
  Floats behind_m = most;
  int first = sides.first_beam();
  for (int i = 0; i < sides.num_blocks(); ++i, first = sides.next_beam(first)) {
    load(view.around.range_m.from(first), range_m);
    const Ints beam = kLane + first;
    const Ints is_beside = (beam > all.first - 1) & (beam < all.last + 1);
    // No comparison holds of what is not a number.
    const Floats farther = range_m - view.range_m + (is_beside ? none : none + kNotANumber);
    open25 -= farther > 0.25F;
    open60 -= farther > 0.6F;
    hidden -= farther < -0.15F;
    lower(nearest_m, farther < 0.0F ? -farther : farther);
    lower(behind_m, farther > -0.1F ? farther : most);
  }
  const SumsOfFour sums = sums_of(open25, open60, hidden, hidden);
  const LeastOfTwo least_m = least_of(nearest_m, behind_m);
  return {sums.first, sums.second, sums.third, least_m.first, least_m.second};
}

[[gnu::always_inline]] inline void find_small_in(std::span<const SmallRun> runs, const LegPlaceLanes& own,
                                                 SmallNeighbours& found) {
  SmallNeighbours best;
  const Floats far = Floats{} + LegSurroundings::kFar_m2;
  for (const SmallRun& run : runs) {
    const BeamSpan& beams = run.place.beams;
    const Ints is_own = (own.first <= beams.last) & (own.last >= beams.first);
    const Floats dx = own.x_m - run.place.x_m;
    const Floats dy = own.y_m - run.place.y_m;
    const Floats distance_m2 = is_own ? far : dx * dx + dy * dy;
    best.num -= distance_m2 < kSmallReach_m * kSmallReach_m;
    best.width_m = distance_m2 < best.nearest_m2 ? Floats{} + run.width_m : best.width_m;
    lower(best.nearest_m2, distance_m2);
  }
  found = best;
}

#if defined(SCANBED_HAS_AVX2)
SCANBED_AVX2 NearEchoes count_near_avx2(const LegView& view, const BeamSpan& all) {
  return count_near_in(view, all);
}

SCANBED_AVX2 BesideBeams look_beside_avx2(const LegView& view, const BeamSpan& all) {
  return look_beside_in(view, all);
}

SCANBED_AVX2 void find_small_avx2(std::span<const SmallRun> runs, const LegPlaceLanes& own,
                                  SmallNeighbours& found) {
  find_small_in(runs, own, found);
}
#endif

}  // namespace

NearEchoes count_near(InstructionSet set, const LegView& view, const BeamSpan& all) {
#if defined(SCANBED_HAS_AVX2)
  if (set == InstructionSet::kAvx2) return count_near_avx2(view, all);
#endif
  return count_near_in(view, all);
}

BesideBeams look_beside(InstructionSet set, const LegView& view, const BeamSpan& all) {
#if defined(SCANBED_HAS_AVX2)
  if (set == InstructionSet::kAvx2) return look_beside_avx2(view, all);
#endif
  return look_beside_in(view, all);
}

void find_small(InstructionSet set, std::span<const SmallRun> runs, const LegPlaceLanes& own,
                SmallNeighbours& found) {
#if defined(SCANBED_HAS_AVX2)
  if (set == InstructionSet::kAvx2) return find_small_avx2(runs, own, found);
#endif
  find_small_in(runs, own, found);
}

}  // namespace scanbed
