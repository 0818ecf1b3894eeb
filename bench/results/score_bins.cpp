// SPDX-License-Identifier: MIT
#include "bench/results/score_bins.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed::bench {
namespace {

constexpr double kTwoSided95 = 1.959964;  // standard deviations

}  // namespace

void ScoreBins::add(double score, bool is_right) {
  const int bin = std::clamp(static_cast<int>(score * kNumScoreBins), 0, kNumScoreBins - 1);
  ++bins_[bin].whole;
  if (is_right) ++bins_[bin].part;
}

ScoreBins& ScoreBins::operator+=(const ScoreBins& other) {
  for (int bin = 0; bin < kNumScoreBins; ++bin) {
    bins_[bin].part += other[bin].part;
    bins_[bin].whole += other[bin].whole;
  }
  return *this;
}

Estimate wilson_interval(const Share& share) {
  if (share.whole == 0) return {0.5, 0.0, 1.0};
  const double n = share.whole;
  const double p = share.part / n;
  const double z2 = kTwoSided95 * kTwoSided95;
  const double middle = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half = kTwoSided95 * std::sqrt(p * (1.0 - p) / n + z2 / (4.0 * n * n)) / (1.0 + z2 / n);
  return {p, std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

}  // namespace scanbed::bench
