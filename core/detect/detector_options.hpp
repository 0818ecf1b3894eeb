// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "core/detect/robust/surface_options.hpp"
#include "core/geometry/angles.hpp"

namespace scanbed {

/// How a scan is cut into segments (paper, II-A).
struct SegmentationOptions {
  double max_gap_m = 0.08;  ///< neighbouring points farther apart than this belong to different segments
  int min_points = 2;       ///< smaller segments are dropped; 2 rejects isolated points
  void validate() const;    ///< @throws InputError naming the first field out of range
};

enum class CircleMethod { kOff, kInscribedAngle };

/// In the order of the values.
inline constexpr std::array<std::string_view, 2> kCircleMethodWords = {"off", "inscribed_angle"};

/// Circles by inscribed angle variance (paper, II-B to II-D).
struct CircleOptions {
  CircleMethod method = CircleMethod::kInscribedAngle;
  double max_std_rad = 0.15;  ///< above 8.6 deg "arc-like" shapes are accepted too, after the V-corner test
  double min_average_rad = radians(90.0);   ///< smaller: more than half a circle in view, which no laser sees
  double max_average_rad = radians(135.0);  ///< larger: flatter arcs are taken for circles
  double min_length_m = 0.15;               ///< chord of the segment; smaller segments are not tried
  double max_length_m = 99.999;             ///< chord of the segment; larger segments are not tried
  int min_points = 4;                       ///< segments with fewer points are not tried
  bool prerequisite =
      true;  ///< test the middle point first (eq. 4): saves time, drops flat and deep segments
  double min_depth_ratio = 0.1;  ///< of the middle point below the chord, per chord length
  double max_depth_ratio = 0.7;
  bool in_lines =
      true;  ///< look for arcs in what the lines leave over (II-B.2); finds only what line.max_error_m spares
  void validate() const;
};

enum class LineMethod { kOff, kRecursiveFit, kInscribedAngle };

/// In the order of the values.
inline constexpr std::array<std::string_view, 3> kLineMethodWords = {"off", "recursive_fit",
                                                                     "inscribed_angle"};

/// Lines by recursive fitting (paper, II-F) or by inscribed angles of 180 degrees (II-B.1).
struct LineOptions {
  LineMethod method = LineMethod::kRecursiveFit;
  double min_length_m = 0.15;                       ///< between the ends; shorter runs are dropped
  int min_points = 5;                               ///< runs with fewer points are dropped
  double max_error_m = 0.1;                         ///< a run splits where a point lies farther off its line
  double max_average_deviation_rad = radians(8.6);  ///< inscribed-angle method: from 180 degrees
  double max_std_rad = 0.15;                        ///< inscribed-angle method
  void validate() const;
};

/// What tells legs from other things.
enum class LegScorer {
  kRules,   ///< size and shape (paper, II-E)
  kForest,  ///< a trained forest that sees the surroundings too
};

/// In the order of the values.
inline constexpr std::array<std::string_view, 2> kLegScorerWords = {"rules", "forest"};

/// Legs. All from min_width_m on belong to the rules.
struct LegOptions {
  bool enabled = true;
  LegScorer scorer = LegScorer::kRules;
  double min_score = 0.0;           ///< legs of a lower score are not reported ...
  double min_doubtful_score = 1.0;  ///< ... but told to tracking from this one on
  double min_width_m = 0.10;        ///< chord of the segment
  double max_width_m = 0.25;
  int min_points = 3;
  double min_depth_ratio = 0.1;  ///< as for circles
  double max_depth_ratio = 0.7;
  void validate() const;
};

/// Which detectors run.
enum class Pipeline {
  kPaper,   ///< segments by a fixed gap, inscribed angles, recursive line fitting
  kRobust,  ///< surfaces by a gap that follows the sensor, lines and arcs compared by chi squared
};

/// In the order of the values.
inline constexpr std::array<std::string_view, 2> kPipelineWords = {"paper", "robust"};

/// All options of the detection pipeline. The robust pipeline takes from circle and line whether they are on,
/// how many points and which length they need.
struct DetectorOptions {
  Pipeline pipeline = Pipeline::kPaper;
  SegmentationOptions segmentation;
  CircleOptions circle;
  LineOptions line;
  LegOptions leg;
  SurfaceOptions surface;  ///< of the robust pipeline
  void validate() const;
};

/// Table II's defaults: the paper's detectors as it describes them.
inline DetectorOptions paper_options() {
  return {};
}

/// Ours, by SurfaceParser and ForestLegDetector: better than the paper's.
inline DetectorOptions robust_options() {
  DetectorOptions options{.pipeline = Pipeline::kRobust};
  options.circle.min_points = 6;
  options.circle.min_length_m = 0.0;
  options.line.min_length_m = 0.2;
  options.leg.scorer = LegScorer::kForest;
  options.leg.min_score = 0.39;
  options.leg.min_doubtful_score = 0.1;
  return options;
}

}  // namespace scanbed
