// SPDX-License-Identifier: MIT
#include "core/detect/detector_options.hpp"

#include "core/detect/circle_detector.hpp"
#include "core/errors/input_error.hpp"

namespace scanbed {
namespace {

void require_depth_band(double min_ratio, double max_ratio, const char* min_name, const char* max_name) {
  require(min_ratio >= 0.0 && min_ratio < 1.0, min_name, min_ratio, "[0, 1)");
  require(max_ratio > min_ratio && max_ratio <= 2.0, max_name, max_ratio, "(min_depth_ratio, 2]");
}

}  // namespace

void SegmentationOptions::validate() const {
  require(max_gap_m > 0.0 && max_gap_m <= 10.0, "segmentation.max_gap_m", max_gap_m, "(0, 10]");
  require(min_points >= 1 && min_points <= 1000, "segmentation.min_points", min_points, "[1, 1000]");
}

void CircleOptions::validate() const {
  require_choice(method, "circle.method", kCircleMethodWords);
  require(max_std_rad > 0.0 && max_std_rad <= kMaxArcLikeStd_rad, "circle.max_std_rad", max_std_rad,
          "(0, 0.402]");
  require(min_average_rad > 0.0 && min_average_rad < kPi, "circle.min_average_rad", min_average_rad,
          "(0, 3.1416)");
  require(max_average_rad > min_average_rad && max_average_rad < kPi, "circle.max_average_rad",
          max_average_rad, "(min_average_rad, 3.1416)");
  require(min_length_m >= 0.0 && min_length_m <= 100.0, "circle.min_length_m", min_length_m, "[0, 100]");
  require(max_length_m > min_length_m && max_length_m <= 1000.0, "circle.max_length_m", max_length_m,
          "(min_length_m, 1000]");
  require(min_points >= 3 && min_points <= 10000, "circle.min_points", min_points, "[3, 10000]");
  require_depth_band(min_depth_ratio, max_depth_ratio, "circle.min_depth_ratio", "circle.max_depth_ratio");
}

void LineOptions::validate() const {
  require_choice(method, "line.method", kLineMethodWords);
  require(min_length_m >= 0.0 && min_length_m <= 100.0, "line.min_length_m", min_length_m, "[0, 100]");
  require(min_points >= 2 && min_points <= 10000, "line.min_points", min_points, "[2, 10000]");
  require(max_error_m > 0.0 && max_error_m <= 10.0, "line.max_error_m", max_error_m, "(0, 10]");
  require(max_average_deviation_rad > 0.0 && max_average_deviation_rad < kPi / 2,
          "line.max_average_deviation_rad", max_average_deviation_rad, "(0, 1.5708)");
  require(max_std_rad > 0.0 && max_std_rad < kPi, "line.max_std_rad", max_std_rad, "(0, 3.1416)");
}

void LegOptions::validate() const {
  require_choice(scorer, "leg.scorer", kLegScorerWords);
  require(min_score >= 0.0 && min_score <= 1.0, "leg.min_score", min_score, "[0, 1]");
  require(min_doubtful_score >= 0.0 && min_doubtful_score <= 1.0, "leg.min_doubtful_score",
          min_doubtful_score, "[0, 1]");
  require(min_width_m > 0.0 && min_width_m <= 1.0, "leg.min_width_m", min_width_m, "(0, 1]");
  require(max_width_m > min_width_m && max_width_m <= 2.0, "leg.max_width_m", max_width_m,
          "(min_width_m, 2]");
  require(min_points >= 3 && min_points <= 1000, "leg.min_points", min_points, "[3, 1000]");
  require_depth_band(min_depth_ratio, max_depth_ratio, "leg.min_depth_ratio", "leg.max_depth_ratio");
}

void DetectorOptions::validate() const {
  require_choice(pipeline, "pipeline", kPipelineWords);
  segmentation.validate();
  circle.validate();
  line.validate();
  leg.validate();
  surface.validate();
}

}  // namespace scanbed
