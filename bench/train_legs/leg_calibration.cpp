// SPDX-License-Identifier: MIT
#include "bench/train_legs/leg_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace scanbed::bench {

Logistic fit_logistic(std::span<const JudgedSum> judged) {
  double a = 1.0;
  double b = 0.0;
  for (int iteration = 0; iteration < 50; ++iteration) {
    double ga = 0, gb = 0, haa = 1e-9, hab = 0, hbb = 1e-9;
    for (const JudgedSum& j : judged) {
      const double p = 1.0 / (1.0 + std::exp(-(a * j.sum + b)));
      const double slope = (j.is_leg ? 1.0 : 0.0) - p;
      const double curvature = p * (1.0 - p);
      ga += slope * j.sum;
      gb += slope;
      haa += curvature * j.sum * j.sum;
      hab += curvature * j.sum;
      hbb += curvature;
    }
    const double det = haa * hbb - hab * hab;
    a += (ga * hbb - gb * hab) / det;
    b += (gb * haa - ga * hab) / det;
  }
  return {a, b};
}

float bound_that_loses(double share, std::vector<float> sums) {
  const auto bound = sums.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sums.size()));
  std::nth_element(sums.begin(), bound, sums.end());
  return *bound;
}

}  // namespace scanbed::bench
