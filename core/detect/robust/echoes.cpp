// SPDX-License-Identifier: MIT
#include "core/detect/robust/echoes.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed {
namespace {

constexpr double kDefaultNoise_m = 0.006;
constexpr double kSmoothStep_m = 0.12;  // a third difference across larger steps is an edge, not noise
constexpr int kMinDifferences = 12;
constexpr double kGrazingRatio = 0.35;  // error of range per step to the neighbour
constexpr double kGrazingStep_m = 0.05;

double noise_of(std::vector<double>& differences_m, const SurfaceOptions& options) {
  const auto within = [&](double noise_m) {
    return std::clamp(noise_m, options.min_noise_m, options.max_noise_m);
  };
  if (differences_m.size() < kMinDifferences) return within(kDefaultNoise_m);
  // The median of |x| is 0.6745 sigma; it is blind to the edges that the test for smoothness let through.
  const auto middle = differences_m.begin() + static_cast<std::ptrdiff_t>(differences_m.size() / 2);
  std::nth_element(differences_m.begin(), middle, differences_m.end());
  const double sigma_m = *middle / 0.6745 / std::sqrt(20.0);
  return within(options.noise_inflation * sigma_m);
}

// Least step to the neighbours where both steps have one sign and are large, else 0.
double grazing_step_m(const Echoes& echoes, int k) {
  if (k == 0 || k + 1 == echoes.size()) return 0.0;
  if (echoes.beam[k + 1] - echoes.beam[k - 1] != 2) return 0.0;
  const double before_m = echoes.range_m[k] - echoes.range_m[k - 1];
  const double after_m = echoes.range_m[k + 1] - echoes.range_m[k];
  if (before_m * after_m <= 0.0) return 0.0;
  const double smaller_m = std::min(std::abs(before_m), std::abs(after_m));
  return smaller_m > kGrazingStep_m ? smaller_m : 0.0;
}

}  // namespace

void EchoReader::tabulate(const ScanGeometry& geometry, int num_beams) {
  geometry_ = geometry;
  cos_.resize(num_beams);
  sin_.resize(num_beams);
  for (int i = 0; i < num_beams; ++i) {
    cos_[i] = std::cos(geometry.bearing_rad(i));
    sin_[i] = std::sin(geometry.bearing_rad(i));
  }
}

void EchoReader::read(const LaserScan& scan, const SurfaceOptions& options, Echoes& echoes) {
  const int num_beams = scan.num_beams();
  const ScanGeometry& g = scan.geometry;
  if (static_cast<int>(cos_.size()) != num_beams || g.first_rad != geometry_.first_rad ||
      g.step_rad != geometry_.step_rad) {
    tabulate(g, num_beams);
  }
  echoes.beam.clear();
  echoes.range_m.clear();
  echoes.ux.clear();
  echoes.uy.clear();
  for (int i = 0; i < num_beams; ++i) {
    // A range of 0 has no direction to fit anything to.
    if (!scan.has_echo(i) || scan.range_m[i] <= 0.0) continue;
    echoes.beam.push_back(i);
    echoes.range_m.push_back(scan.range_m[i]);
    echoes.ux.push_back(cos_[i]);
    echoes.uy.push_back(sin_[i]);
  }
  echoes.step_rad = std::abs(g.step_rad);
  differences_.clear();
  const std::vector<double>& r = echoes.range_m;
  for (int k = 3; k < echoes.size(); ++k) {
    const double spread_m =
        std::abs(r[k] - r[k - 1]) + std::abs(r[k - 1] - r[k - 2]) + std::abs(r[k - 2] - r[k - 3]);
    if (echoes.beam[k] - echoes.beam[k - 3] != 3 || spread_m > kSmoothStep_m) continue;
    differences_.push_back(std::abs(r[k] - 3.0 * r[k - 1] + 3.0 * r[k - 2] - r[k - 3]));
  }
  echoes.range_noise_m = noise_of(differences_, options);
  echoes.sigma_m.resize(r.size());
  for (int k = 0; k < echoes.size(); ++k) {
    echoes.sigma_m[k] = std::hypot(echoes.range_noise_m, kGrazingRatio * grazing_step_m(echoes, k));
  }
}

}  // namespace scanbed
