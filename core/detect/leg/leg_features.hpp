// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "core/detect/features.hpp"
#include "core/detect/leg/leg_arcs.hpp"
#include "core/detect/leg/leg_beams.hpp"
#include "core/detect/leg/leg_candidates.hpp"
#include "core/detect/leg/leg_place.hpp"
#include "core/detect/leg/leg_surroundings.hpp"
#include "core/simd/float_lanes.hpp"
#include "core/simd/instruction_set.hpp"

namespace scanbed {

/// What is measured of a candidate, in this order. Lengths in metres; "near" counts echoes outside the
/// candidate around its centroid, times the beam spacing at its range; "beside" are the beams within 0.5 m of
/// it, across. A beam without echo sees infinitely far.
enum class LegFeature {
  kNumPoints,
  kWidth,           ///< from end to end
  kFilled,          ///< points times beam spacing, in legs of 0.13 m
  kRange,           ///< mean
  kNear30,          ///< echoes within 0.3 m
  kNear50,          ///< within 0.5 m
  kNear100,         ///< within 1 m
  kNearWall100,     ///< of the latter, those on wall-like runs: wider than 0.5 m
  kNearest,         ///< distance of the nearest echo, at most 1 m
  kNearestWall,     ///< of the nearest on a wall-like run, at most 1 m
  kNumSmall,        ///< other runs 0.008 to 0.25 m wide within 1 m
  kNearestSmall,    ///< distance of the nearest of them, at most 1.5 m
  kSmallWidth,      ///< its width, -1 without
  kCircleResidual,  ///< root mean square about the algebraic (Kasa) circle
  kCircleRadius,    ///< negative where its centre lies nearer than the points; at most 0.5 in size
  kLineResidual,    ///< root mean square about the line of total least squares
  kBow,             ///< mean distance before the chord, towards the sensor, over width
  kInscribed,       ///< mean cosine of the inscribed angles at a quarter, a half and three quarters
  kTilt,            ///< difference of range between the ends, over width
  kRangeStd,        ///< standard deviation of range
  kStep,            ///< root mean square of the steps of range
  kFineWidth,       ///< of the run that holds its middle, in the fine segmentation
  kMiddleWidth,     ///< in the middle one
  kCoarseWidth,     ///< in the coarse one
  kLeastJump,       ///< from an end to the next beam, away from the sensor; the lesser, within +-2
  kLargestJump,     ///< the greater
  kOpen25,          ///< share of the beams beside that see 0.25 m farther
  kOpen60,          ///< 0.6 m farther
  kHidden,          ///< share of the beams beside that end 0.15 m before
  kNearestBeside,   ///< least difference of range to a beam beside, at most 2
  kNearestBehind,   ///< to one that sees no more than 0.1 m less far
  kArcRadius,       ///< of the circle on which its middle lies, at most 1; 0 where on none
  kArcShare,        ///< its points over the echoes on that circle, at most 4; 1 without
  kPartner35,       ///< greatest sum of a candidate beside it within 0.35 m (leg_partners.hpp)
  kPartner80,       ///< within 0.8 m
  kRival,           ///< of one that shares beams with it
  kCount,
};

inline constexpr int kNumLegFeatures = static_cast<int>(LegFeature::kCount);
/// What is measured of each candidate by itself stands before what others add.
inline constexpr int kNumOwnLegFeatures = static_cast<int>(LegFeature::kPartner35);

/// What is measured of one candidate, wherever it stands.
class LegFeatureColumn {
 public:
  explicit LegFeatureColumn(float* first) : first_(first) {}
  float& at(LegFeature feature) const { return first_[kNumLanes * static_cast<std::ptrdiff_t>(feature)]; }

 private:
  float* first_;
};

/// Features of many candidates, in blocks: what is read together stands together.
class LegFeatureTable {
 public:
  static constexpr int kBlock = kNumLanes;  ///< candidates

  /// Makes room for so many candidates, padded to whole blocks.
  void resize(int num_candidates);
  /// Keeps the first candidates alone; what stands in the padding does not matter.
  void shrink(int num_candidates) { num_candidates_ = num_candidates; }
  /// Lets candidate `to` have the features of candidate `from`.
  void copy(int from, int to);
  int num_candidates() const { return num_candidates_; }
  int num_blocks() const { return (num_candidates_ + kBlock - 1) / kBlock; }
  float& at(int feature, int candidate) { return values_[index(feature, candidate)]; }
  float at(int feature, int candidate) const { return values_[index(feature, candidate)]; }
  LegFeatureColumn column(int candidate) { return LegFeatureColumn(&at(0, candidate)); }
  /// Feature f of the block's i-th candidate stands at kBlock f + i.
  const float* block(int number) const { return values_.data() + index(0, kBlock * number); }
  /// Sets a feature of all the block's candidates.
  void write(LegFeature feature, int block, const Floats& values) {
    store(values, values_.data() + index(static_cast<int>(feature), kBlock * block));
  }
  std::span<const float> blocks_from(int number) const { return {block(number), block(num_blocks())}; }

 private:
  static std::size_t index(int feature, int candidate) {
    const int place = (candidate / kBlock * kNumLegFeatures + feature) * kBlock + candidate % kBlock;
    return static_cast<std::size_t>(place);
  }

  int num_candidates_ = 0;
  std::vector<float> values_;
};

/// Measures candidates; every feature is the same for a scan that is turned, and for its mirror image.
class LegFeatureReader {
 public:
  explicit LegFeatureReader(InstructionSet instructions = widest_instruction_set())
      : instructions_(instructions) {}

  /// Reads all but what the candidates say of each other (leg_partners.hpp).
  /// @param surfaces  what was found in the scan: candidates ask for its circles.
  void read(const LegBeams& beams, const LegCandidates& candidates, const Features& surfaces,
            LegFeatureTable& table);
  /// Of the candidates read last.
  const std::vector<LegPlace>& places() const { return places_; }

 private:
  /// How far a candidate's surroundings go, itself included.
  struct Extent {
    float range_m = 0.0F, spacing_m = 0.0F;  ///< mean, and between its beams there
    BeamSpan near, beside;
  };
  using Values = LegFeatureColumn;

  void mark_surroundings(const LegBeams& beams, const LegSegmentation& segmentation);
  void read_shape(const LegBeams& beams, const EchoRun& run, int candidate, Values values);
  void find_extents(const LegBeams& beams);
  void read_near(int candidate, Values values) const;
  void read_beside(int candidate, Values values) const;
  void read_arc(const LegBeams& beams, const EchoRun& run, Values values) const;
  void read_small_neighbours(LegFeatureTable& table) const;

  InstructionSet instructions_;
  LegSurroundings around_;
  std::vector<SmallRun> small_runs_;
  LegArcs arcs_;
  // Of each candidate.
  std::vector<LegPlace> places_;
  std::vector<Extent> extents_;
};

/// Mean position of a run's echoes, sensor frame S.
Eigen::Vector2d centroid_m(const LegBeams& beams, const EchoRun& run);

}  // namespace scanbed
