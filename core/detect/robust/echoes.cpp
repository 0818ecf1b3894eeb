// SPDX-License-Identifier: MIT
#include "core/detect/robust/echoes.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed {
namespace {

constexpr double kDefaultNoise_m = 0.006;
constexpr double kSmoothStep_m = 0.12;  // a third difference across larger steps is an edge, not noise
constexpr int kMinDifferences = 12;
constexpr double kBin_m = 0.00025;      // of a difference; 0.00008 of a sigma
constexpr double kGrazingRatio = 0.35;  // error of range per step to the neighbour
constexpr double kGrazingStep_m = 0.05;

// Least step to both neighbours where both steps have one sign and are large, else 0.
double grazing_step_m(const Echoes& echoes, int k) {
  const double before_m = echoes.range_m[k] - echoes.range_m[k - 1];
  if (std::abs(before_m) <= kGrazingStep_m || echoes.beam[k + 1] - echoes.beam[k - 1] != 2) return 0.0;
  const double after_m = echoes.range_m[k + 1] - echoes.range_m[k];
  if (before_m * after_m <= 0.0) return 0.0;
  const double smaller_m = std::min(std::abs(before_m), std::abs(after_m));
  return smaller_m > kGrazingStep_m ? smaller_m : 0.0;
}

}  // namespace

void NoiseHistogram::clear() {
  counts_.fill(0);
  num_counted_ = 0;
}

void NoiseHistogram::add(double difference_m) {
  const double bin = std::min(std::abs(difference_m) / kBin_m, kNumBins - 1.0);
  ++counts_[static_cast<std::size_t>(bin)];
  ++num_counted_;
}

// The median of |x| is 0.6745 sigma; it is blind to the edges that the test for smoothness let through.
std::optional<double> NoiseHistogram::sigma_m() const {
  if (num_counted_ < kMinDifferences) return std::nullopt;
  const double half = 0.5 * num_counted_;
  double below = 0.0;
  int bin = 0;
  while (below + counts_[bin] < half) below += counts_[bin++];
  const double median_m = kBin_m * (bin + (half - below) / counts_[bin]);
  return median_m / 0.6745 / std::sqrt(20.0);
}

void EchoReader::read(const LaserScan& scan, const SurfaceOptions& options, Echoes& echoes) {
  const int num_beams = scan.num_beams();
  directions_.follow(scan);
  echoes.beam.resize(num_beams);
  for (std::vector<double>* column : {&echoes.range_m, &echoes.ux, &echoes.uy, &echoes.x_m, &echoes.y_m}) {
    column->resize(num_beams);
  }
  int num_echoes = 0;
  for (int i = 0; i < num_beams; ++i) {
    const double range_m = scan.range_m[i];
    // Overwritten by the next one where this is no echo; a range of 0 has no direction to fit anything to.
    echoes.beam[num_echoes] = i;
    echoes.range_m[num_echoes] = range_m;
    echoes.ux[num_echoes] = directions_.x(i);
    echoes.uy[num_echoes] = directions_.y(i);
    echoes.x_m[num_echoes] = range_m * directions_.x(i);
    echoes.y_m[num_echoes] = range_m * directions_.y(i);
    num_echoes += std::isfinite(range_m) && range_m > 0.0 ? 1 : 0;
  }
  echoes.beam.resize(num_echoes);
  for (std::vector<double>* column : {&echoes.range_m, &echoes.ux, &echoes.uy, &echoes.x_m, &echoes.y_m}) {
    column->resize(num_echoes);
  }
  const double step_rad = scan.geometry.step_rad;
  echoes.step_rad = std::abs(step_rad);
  echoes.step = {std::cos(step_rad), std::sin(step_rad)};
  estimate_noise(options, echoes);
  spread_noise(echoes);
}

void EchoReader::estimate_noise(const SurfaceOptions& options, Echoes& echoes) {
  noise_.clear();
  const std::vector<double>& r = echoes.range_m;
  for (int k = 3; k < echoes.size(); ++k) {
    const double spread_m =
        std::abs(r[k] - r[k - 1]) + std::abs(r[k - 1] - r[k - 2]) + std::abs(r[k - 2] - r[k - 3]);
    if (echoes.beam[k] - echoes.beam[k - 3] != 3 || !(spread_m <= kSmoothStep_m)) continue;
    // By steps, which do not overflow where ranges would.
    noise_.add((r[k] - r[k - 1]) - 2.0 * (r[k - 1] - r[k - 2]) + (r[k - 2] - r[k - 3]));
  }
  const std::optional<double> sigma_m = noise_.sigma_m();
  echoes.range_noise_m = std::clamp(sigma_m ? options.noise_inflation * *sigma_m : kDefaultNoise_m,
                                    options.min_noise_m, options.max_noise_m);
}

void EchoReader::spread_noise(Echoes& echoes) const {
  echoes.sigma_m.assign(echoes.range_m.size(), echoes.range_noise_m);
  for (int k = 1; k + 1 < echoes.size(); ++k) {
    const double step_m = grazing_step_m(echoes, k);
    if (step_m > 0.0) echoes.sigma_m[k] = std::hypot(echoes.range_noise_m, kGrazingRatio * step_m);
  }
}

}  // namespace scanbed
