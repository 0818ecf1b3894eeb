// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace scanbed::bench {

/// What a forest's trees add up to for a detection whose answer is known.
struct JudgedSum {
  double sum = 0.0;
  bool is_leg = false;
};

/// Probability 1 / (1 + exp(-(slope sum + offset))).
struct Logistic {
  double slope = 1.0;
  double offset = 0.0;
};

/// Logistic regression of the answer on the sum, by Newton's method.
/// @pre  no sum parts all yes from all no: the slope would have no bound.
Logistic fit_logistic(std::span<const JudgedSum> judged);

/// The greatest bound below which no more than this share of the sums lies.
/// @pre  there are sums; 0 <= share < 1.
float bound_that_loses(double share, std::vector<float> sums);

}  // namespace scanbed::bench
