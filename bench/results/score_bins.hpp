// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "bench/results/bootstrap.hpp"

namespace scanbed::bench {

inline constexpr int kNumScoreBins = 10;

/// Detections by their score, in steps of 0.1: how many there are, and how many of these are right. Where
/// scores are probabilities, the share is about the score.
class ScoreBins {
 public:
  /// @param score  in [0, 1]; 1 belongs to the last bin.
  void add(double score, bool is_right);
  ScoreBins& operator+=(const ScoreBins& other);

  /// Right ones of those from 0.1 * bin up to 0.1 * (bin + 1).
  const Share& operator[](int bin) const { return bins_[bin]; }

 private:
  std::array<Share, kNumScoreBins> bins_;
};

/// A share with the interval that holds the true one in 95 of 100 draws, were they independent; scans of one
/// run are less than that. 0 to 1 where nothing was drawn.
///
/// @par Source  Wilson, "Probable Inference, the Law of Succession, and Statistical Inference", JASA 1927.
Estimate wilson_interval(const Share& share);

}  // namespace scanbed::bench
