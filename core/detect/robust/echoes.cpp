// SPDX-License-Identifier: MIT
#include "core/detect/robust/echoes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanbed {
namespace {

constexpr double kDefaultNoise_m = 0.006;
constexpr double kSmoothStep_m = 0.12;  // a third difference across larger steps is an edge, not noise
constexpr int kMinDifferences = 12;
constexpr double kBin_m = 0.00025;      // of a difference; 0.00008 of a sigma
constexpr double kGrazingRatio = 0.35;  // error of range per step to the neighbour
constexpr double kGrazingStep_m = 0.05;

void resize(Echoes& echoes, int num_echoes) {
  echoes.beam.resize(num_echoes);
  for (std::vector<double>* column : {&echoes.range_m, &echoes.x_m, &echoes.y_m}) column->resize(num_echoes);
}

void project(const LaserScan& scan, Echoes& echoes) {
  const int num_beams = scan.num_beams();
  resize(echoes, num_beams);
  int* const beam = echoes.beam.data();
  double* const r_m = echoes.range_m.data();
  double* const x_m = echoes.x_m.data();
  double* const y_m = echoes.y_m.data();
  int num_echoes = 0;
  for (int i = 0; i < num_beams; ++i) {
    const double range_m = scan.range_m[i];
    // Overwritten by the next one where this is no echo; a range of 0 has no direction to fit anything to.
    beam[num_echoes] = i;
    r_m[num_echoes] = range_m;
    x_m[num_echoes] = range_m * echoes.directions.x(i);
    y_m[num_echoes] = range_m * echoes.directions.y(i);
    num_echoes += range_m > 0.0 && range_m <= std::numeric_limits<double>::max() ? 1 : 0;
  }
  resize(echoes, num_echoes);
}

}  // namespace

// Beams without echo are far from their neighbours, or no number: no smooth run holds them.
void NoiseHistogram::sort_into_bins(std::span<const double> range_m) {
  bins_.resize(range_m.size() - 3);
  const double* const r = range_m.data();
  int* const bins = bins_.data();
  const auto num_bins = static_cast<int>(bins_.size());
  for (int k = 0; k < num_bins; ++k) {
    // By steps, which do not overflow where ranges would.
    const double a = r[k + 1] - r[k];
    const double b = r[k + 2] - r[k + 1];
    const double c = r[k + 3] - r[k + 2];
    const double bin = std::min(std::abs(c - 2.0 * b + a) * (1.0 / kBin_m), kNumBins - 1.0);
    const bool is_smooth = std::abs(c) + std::abs(b) + std::abs(a) <= kSmoothStep_m;
    bins[k] = static_cast<int>(is_smooth ? bin : kNoBin);
  }
}

void NoiseHistogram::count() {
  for (Counts& counts : counts_) counts.fill(0);
  const std::size_t num_pairs = bins_.size() / 2;
  for (std::size_t i = 0; i < num_pairs; ++i) {
    ++counts_[0][bins_[2 * i]];
    ++counts_[1][bins_[2 * i + 1]];
  }
  if (bins_.size() % 2 == 1) ++counts_[0][bins_.back()];
  num_counted_ = static_cast<int>(bins_.size()) - counts_[0][kNoBin] - counts_[1][kNoBin];
}

double NoiseHistogram::median_m() const {
  const auto count_of = [&](int bin) { return counts_[0][bin] + counts_[1][bin]; };
  int below = 0;
  int bin = 0;
  while (2 * (below + count_of(bin)) < num_counted_) below += count_of(bin++);
  return kBin_m * (bin + (0.5 * num_counted_ - below) / count_of(bin));
}

// The median of |x| is 0.6745 sigma; it is blind to the edges that the test for smoothness let through.
std::optional<double> NoiseHistogram::sigma_m(std::span<const double> range_m) {
  if (range_m.size() < 3 + kMinDifferences) return std::nullopt;
  sort_into_bins(range_m);
  count();
  if (num_counted_ < kMinDifferences) return std::nullopt;
  return median_m() / 0.6745 / std::sqrt(20.0);
}

void EchoReader::read(const LaserScan& scan, const SurfaceOptions& options, Echoes& echoes) {
  echoes.directions.follow(scan);
  echoes.step_rad = std::abs(scan.geometry.step_rad);
  project(scan, echoes);
  const std::optional<double> sigma_m = noise_.sigma_m(scan.range_m);
  echoes.range_noise_m = std::clamp(sigma_m ? options.noise_inflation * *sigma_m : kDefaultNoise_m,
                                    options.min_noise_m, options.max_noise_m);
  weigh(echoes);
}

void EchoReader::weigh(Echoes& echoes) {
  const int num_echoes = echoes.size();
  const double variance_m2 = echoes.range_noise_m * echoes.range_noise_m;
  echoes.weight_per_m2.assign(num_echoes, 1.0 / variance_m2);
  grazing_step_m_.resize(num_echoes);
  const double* const r_m = echoes.range_m.data();
  double* const steps_m = grazing_step_m_.data();
  for (int k = 1; k + 1 < num_echoes; ++k) {
    const double before_m = r_m[k] - r_m[k - 1];
    const double after_m = r_m[k + 1] - r_m[k];
    // The lesser step where both have one sign, else less than nothing.
    steps_m[k] = std::max(std::min(before_m, after_m), -std::max(before_m, after_m));
  }
  for (int k = 1; k + 1 < num_echoes; ++k) {
    if (steps_m[k] <= kGrazingStep_m || echoes.beam[k + 1] - echoes.beam[k - 1] != 2) continue;
    const double error_m = kGrazingRatio * steps_m[k];
    echoes.weight_per_m2[k] = 1.0 / (variance_m2 + error_m * error_m);
  }
}

}  // namespace scanbed
