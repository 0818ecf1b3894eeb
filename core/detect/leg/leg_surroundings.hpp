// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/detect/features.hpp"
#include "core/detect/leg/leg_place.hpp"
#include "core/simd/float_lanes.hpp"
#include "core/simd/instruction_set.hpp"

namespace scanbed {

/// A value of each beam between blocks of padding, so that whole blocks can be read from any beam on and
/// before.
class PaddedBeams {
 public:
  /// Takes over values that are padded behind, by one block at least.
  void copy(const std::vector<float>& values) {
    values_.resize(values.size() + kNumLanes);
    std::fill_n(values_.begin(), kNumLanes, values.back());
    std::copy(values.begin(), values.end(), from(0));
  }
  void fill(std::size_t num_values, float value) { values_.assign(num_values + kNumLanes, value); }
  float* from(int beam) { return values_.data() + kNumLanes + beam; }
  const float* from(int beam) const { return values_.data() + kNumLanes + beam; }

 private:
  std::vector<float> values_;
};

/// A scan as a candidate for a leg sees it around itself.
struct LegSurroundings {
  static constexpr float kNearReach_m = 1.0F;
  static constexpr float kMaxJump_m = 2.0F;
  static constexpr float kMaxSmallDistance_m = 1.5F;
  static constexpr float kFar_m2 = 1e6F;  ///< beyond all reaches

  PaddedBeams range_m, x_m, y_m;
  PaddedBeams off_wall_m2;  ///< 0 on a wall-like run, else kFar_m2
};

/// A candidate among them.
struct LegView {
  const LegSurroundings& around;
  const LegPlace& own;
  float range_m = 0.0F;  ///< mean
};

/// Echoes around a candidate, of other beams than its own.
struct NearEchoes {
  int num_within30 = 0, num_within50 = 0, num_within100 = 0;
  int num_wall100 = 0;                              ///< within 1 m on wall-like runs
  float nearest_m2 = 0.0F, nearest_wall_m2 = 0.0F;  ///< at most 1
};

/// @param all  beams of which no other has an echo within reach; the candidate's are among them.
NearEchoes count_near(InstructionSet set, const LegView& view, const BeamSpan& all);

/// What beams beside a candidate see.
struct BesideBeams {
  int num_open25 = 0, num_open60 = 0;  ///< 0.25 and 0.6 m farther
  int num_hidden = 0;                  ///< 0.15 m less far
  float nearest_m = 0.0F;              ///< least difference of range, at most 2
  float behind_m = 0.0F;               ///< of those that see no more than 0.1 m less far
};

/// @param all  the candidate's beams and those beside it.
BesideBeams look_beside(InstructionSet set, const LegView& view, const BeamSpan& all);

/// A run that could be somebody's other leg.
struct SmallRun {
  LegPlace place;
  float width_m = 0.0F;
};

/// Small runs around each candidate of a block, of other beams than its own.
struct SmallNeighbours {
  Ints num{};  ///< within 1 m
  Floats nearest_m2 = Floats{} + LegSurroundings::kMaxSmallDistance_m * LegSurroundings::kMaxSmallDistance_m;
  Floats width_m = Floats{} - 1.0F;  ///< of the nearest, -1 without
};

void find_small(InstructionSet set, std::span<const SmallRun> runs, const LegPlaceLanes& own,
                SmallNeighbours& found);

}  // namespace scanbed
