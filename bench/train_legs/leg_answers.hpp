// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/detect/features.hpp"
#include "core/detect/leg/leg_features.hpp"
#include "core/scan/laser_scan.hpp"
#include "core/scan/truth.hpp"

namespace scanbed::bench {

enum class LegAnswer { kUnknown = -1, kNo = 0, kYes = 1 };

/// A candidate with its features and what it is.
struct LegSample {
  int scan = 0;
  BeamSpan beams;
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();  ///< centroid, sensor frame
  LegAnswer answer = LegAnswer::kUnknown;
  std::array<float, kNumLegFeatures> features{};
};

/// By the labels of a recording's scan. Within 0.10 m of a label it is a leg. People are labelled within 15
/// degrees and 5 m only: there, what lies farther than 0.30 m from all labels is none, and all else is
/// unknown.
LegAnswer answer_by_labels(const LegSample& sample, const std::vector<Eigen::Vector2d>& labels);

/// By the truth of a simulated scan. A leg if at least 75 % of its echoes come from one leg, and are at least
/// 65 % of that leg's; none if fewer than 40 % come from legs and fewer than 30 % from cylinders that might
/// be legs. Two that touch are unknown together: recordings have one label for some of them, worlds have two
/// legs.
LegAnswer answer_by_truth(const LegSample& sample, const LaserScan& scan, const Truth& truth);

}  // namespace scanbed::bench
