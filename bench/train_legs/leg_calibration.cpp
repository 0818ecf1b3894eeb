// SPDX-License-Identifier: MIT
#include "bench/train_legs/leg_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace scanbed::bench {
namespace {

constexpr int kMaxIterations = 50;
constexpr int kMaxHalvings = 20;  // of a step

double probability(const Logistic& logistic, double sum) {
  return 1.0 / (1.0 + std::exp(-(logistic.slope * sum + logistic.offset)));
}

// Minus the log-likelihood; log(1 + e^x) without overflow.
double loss_of(const Logistic& logistic, std::span<const JudgedSum> judged) {
  double loss = 0.0;
  for (const JudgedSum& j : judged) {
    const double log_odds = logistic.slope * j.sum + logistic.offset;
    const double against = j.is_leg ? -log_odds : log_odds;
    loss += std::max(against, 0.0) + std::log1p(std::exp(-std::abs(against)));
  }
  return loss;
}

Logistic newton_step(const Logistic& at, std::span<const JudgedSum> judged) {
  double ga = 0.0, gb = 0.0, haa = 1e-9, hab = 0.0, hbb = 1e-9;
  for (const JudgedSum& j : judged) {
    const double p = probability(at, j.sum);
    const double slope = (j.is_leg ? 1.0 : 0.0) - p;
    const double curvature = p * (1.0 - p);
    ga += slope * j.sum;
    gb += slope;
    haa += curvature * j.sum * j.sum;
    hab += curvature * j.sum;
    hbb += curvature;
  }
  const double det = haa * hbb - hab * hab;
  return {(ga * hbb - gb * hab) / det, (gb * haa - ga * hab) / det};
}

}  // namespace

// A step that overshoots is halved.
Logistic fit_logistic(std::span<const JudgedSum> judged) {
  Logistic best{.slope = 0.0, .offset = 0.0};
  double least_loss = loss_of(best, judged);
  for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
    const Logistic step = newton_step(best, judged);
    for (int halving = 0; halving < kMaxHalvings; ++halving) {
      const double share = std::ldexp(1.0, -halving);
      const Logistic next{best.slope + share * step.slope, best.offset + share * step.offset};
      const double loss = loss_of(next, judged);
      if (loss >= least_loss) continue;
      best = next;
      least_loss = loss;
      break;
    }
  }
  return best;
}

float bound_that_loses(double share, std::vector<float> sums) {
  const auto bound = sums.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sums.size()));
  std::nth_element(sums.begin(), bound, sums.end());
  return *bound;
}

}  // namespace scanbed::bench
