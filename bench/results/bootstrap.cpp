// SPDX-License-Identifier: MIT
#include "bench/results/bootstrap.hpp"

#include <algorithm>
#include <cstddef>

#include "sim/generate/world_dice.hpp"

namespace scanbed::bench {
namespace {

constexpr int kNumResamples = 1000;

double ratio(const Share& sum) {
  return sum.whole == 0 ? 1.0 : static_cast<double>(sum.part) / sum.whole;
}

}  // namespace

Estimate pooled_share(const std::vector<Share>& runs) {
  const auto add = [](Share& sum, const Share& run) {
    sum.part += run.part;
    sum.whole += run.whole;
  };
  Share all;
  for (const Share& run : runs) add(all, run);
  std::vector<double> ratios;
  sim::WorldDice dice(1, "bootstrap");
  const int num_runs = static_cast<int>(runs.size());
  for (int i = 0; i < kNumResamples; ++i) {
    Share sum;
    for (int k = 0; k < num_runs; ++k) add(sum, runs[dice.whole(0, num_runs - 1)]);
    ratios.push_back(ratio(sum));
  }
  std::sort(ratios.begin(), ratios.end());
  return {ratio(all), ratios[kNumResamples / 40], ratios[kNumResamples - 1 - kNumResamples / 40]};
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace scanbed::bench
