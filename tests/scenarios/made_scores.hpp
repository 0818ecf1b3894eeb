// SPDX-License-Identifier: MIT
#pragma once

#include "core/score/tally.hpp"

namespace scanbed::testing {

/// Scores of ten scans, by hand. Circles: 8 of 10 found (3 of 4 at 2-4 m, 5 of 6 at 4-6 m), 8 of 16 right, an
/// error of 0.03 m each. Lines and legs: nothing to find; one wrong leg.
inline Scores made_scores() {
  Scores scores;
  scores.num_scans = 10;
  KindScore& circle = scores.circle;
  for (int i = 0; i < 4; ++i) circle.count_truth(3.0, i < 3);
  for (int i = 0; i < 6; ++i) circle.count_truth(5.0, i < 5);
  circle.tally.num_detections = 16;
  circle.tally.num_right = 8;
  circle.tally.sum_squared_error_m2 = 8 * 0.03 * 0.03;
  scores.leg.tally.num_detections = 1;
  return scores;
}

}  // namespace scanbed::testing
