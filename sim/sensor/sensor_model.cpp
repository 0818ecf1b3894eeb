// SPDX-License-Identifier: MIT
#include "sim/sensor/sensor_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/random/gaussian_pair.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed::sim {
namespace {

constexpr double kSurelySeen = 1.0;   // strength of an echo
constexpr double kSurelyLost = 0.25;  // likewise
constexpr double kFar_m = 1e6;        // no laser reaches so far
constexpr int kLanes = 8;             // pairs of beams whose random numbers are made at once

/// Uniform in the open interval (0, 1).
double unit(std::uint32_t word) {
  return (static_cast<double>(word) + 0.5) * 0x1p-32;
}

}  // namespace

SensorModel::SensorModel(const SensorOptions& options, std::uint64_t seed, std::vector<Material> materials)
    : options_(options),
      random_(seed, "laser"),
      materials_(std::move(materials)),
      reach_scale_m2_(options.dropout.reach_m * options.dropout.reach_m / 0.1),
      cos_glass_cone_(std::cos(options.dropout.glass_cone_rad)),
      cos_glint_(options.dazzle.glint_rad > 0.0 ? std::cos(options.dazzle.glint_rad) : 2.0),
      range_limit_m_(options.range_limit_m()),
      any_glass_(
          std::any_of(materials_.begin(), materials_.end(), [](const Material& m) { return m.glass; })) {}

void SensorModel::measure(const IdealReturns& returns, std::int64_t scan, std::vector<double>& range_m) {
  const int num_beams = static_cast<int>(returns.range_m.size());
  scan_ = scan;
  range_m.resize(num_beams);
  echoes_.resize(num_beams);
  for (int i = 0; i < num_beams; ++i) echoes_[i] = axis_echo(returns, i);
  for (const SplitSpot& spot : returns.split_spots) echoes_[spot.beam] = spot_echo(returns, spot);
  draw(num_beams);
  make_waves();
  for (int i = 0; i < num_beams; ++i) range_m[i] = reading_m(i);
  if (!options_.exact_ranges) round_to_lms_words(range_m, options_.unit, options_.word_bits);
}

SensorModel::Echo SensorModel::axis_echo(const IdealReturns& returns, int beam) const {
  const int object = returns.object[beam];
  return {returns.range_m[beam], returns.cos_incidence[beam],
          object == kNoObject ? nullptr : &materials_[object]};
}

// The rays of a spot fall into bunches no farther apart in depth than the pulse is long; of the brightest
// bunch the middle is measured, each ray by its light.
SensorModel::Echo SensorModel::spot_echo(const IdealReturns& returns, const SplitSpot& spot) {
  const auto first = returns.spot_returns.begin() + spot.first;
  sorted_.assign(first, first + spot.count);
  std::sort(sorted_.begin(), sorted_.end(),
            [](const SpotReturn& a, const SpotReturn& b) { return a.range_m < b.range_m; });
  Echo brightest{kNoEcho, 1.0, nullptr};
  double brightest_light = 0.0;
  for (std::size_t i = 0; i < sorted_.size() && sorted_[i].object != kNoObject;) {
    double light = 0.0;
    double moment_m = 0.0;
    std::size_t strongest = i;
    double strongest_light = 0.0;
    const std::size_t begin = i;
    do {
      const SpotReturn& ray = sorted_[i];
      const Material& material = materials_[ray.object];
      const bool returns_light = !material.glass || ray.cos_incidence >= cos_glass_cone_;
      const double ray_light = returns_light ? ray.weight * material.reflectivity * ray.cos_incidence : 0.0;
      light += ray_light;
      moment_m += ray_light * ray.range_m;
      if (ray_light > strongest_light) {
        strongest_light = ray_light;
        strongest = i;
      }
      ++i;
    } while (i < sorted_.size() && sorted_[i].object != kNoObject &&
             sorted_[i].range_m - sorted_[i - 1].range_m <= options_.spot.pulse_m);
    const double inverse_square = light / (sorted_[begin].range_m * sorted_[begin].range_m);
    if (light == 0.0 || inverse_square <= brightest_light) continue;
    brightest_light = inverse_square;
    brightest = {moment_m / light, sorted_[strongest].cos_incidence, &materials_[sorted_[strongest].object]};
  }
  return brightest;
}

// Four words give two beams their Gaussians and a word each for loss.
void SensorModel::draw(int num_beams) {
  const int num_padded = (num_beams + 2 * kLanes - 1) / (2 * kLanes) * (2 * kLanes);
  gaussian_.resize(num_padded);
  loss_word_.resize(num_padded);
  const EffectScales& effects = options_.effects;
  if (effects.noise == 0.0 && effects.dropout == 0.0) return;
  for (int beam = 0; beam < num_beams; beam += 2 * kLanes) {
    std::array<std::array<std::uint32_t, kLanes>, 4> words;
    random_.bits(scan_, beam / 2, words);
    std::array<double, kLanes> right{};
    std::array<double, kLanes> left{};
    for (int lane = 0; lane < kLanes; ++lane) {
      std::tie(right[lane], left[lane]) = gaussian_pair(words[0][lane], words[1][lane]);
    }
    for (int lane = 0; lane < kLanes; ++lane) {
      gaussian_[beam + 2 * lane] = right[lane];
      gaussian_[beam + 2 * lane + 1] = left[lane];
      loss_word_[beam + 2 * lane] = words[2][lane];
      loss_word_[beam + 2 * lane + 1] = words[3][lane];
    }
  }
}

// The wave of the bias over range, of all beams at once.
void SensorModel::make_waves() {
  if (options_.effects.bias == 0.0 || options_.bias.cyclic_m == 0.0) return;
  wave_.resize(echoes_.size());
  for (std::size_t i = 0; i < echoes_.size(); ++i) {
    const double range_m = echoes_[i].range_m < kFar_m ? echoes_[i].range_m : 0.0;
    wave_[i] = sine_of_turns(range_m / options_.bias.cyclic_period_m);
  }
}

// The next block of words has one for each of two beams.
bool SensorModel::is_dazzled(const Echo& echo, int beam) const {
  if (options_.effects.dazzle == 0.0 || (options_.dazzle.probability == 0.0 && !any_glass_)) return false;
  const std::uint32_t word = random_.bits(scan_, beam / 2, 1)[beam % 2];
  const bool glints = echo.material != nullptr && echo.material->glass && echo.cos_incidence >= cos_glint_;
  const double probability = options_.effects.dazzle * (glints ? 1.0 : options_.dazzle.probability);
  return unit(word) < probability;
}

double SensorModel::reading_m(int beam) const {
  const Echo& echo = echoes_[beam];
  if (is_dazzled(echo, beam)) return kInvalid;
  if (echo.material == nullptr) return kNoEcho;
  if (unit(loss_word_[beam]) < loss_probability(echo.range_m, echo.cos_incidence, *echo.material)) {
    return kNoEcho;
  }
  double range_m = echo.range_m;
  if (options_.effects.bias != 0.0) {
    const double wave = wave_.empty() ? 0.0 : wave_[beam];
    range_m += bias_of_wave_m(wave, echo.cos_incidence, *echo.material);
  }
  if (options_.effects.noise != 0.0) {
    range_m += sigma_m(echo.range_m, echo.cos_incidence, *echo.material) * gaussian_[beam];
  }
  if (range_m > range_limit_m_) return kNoEcho;
  range_m = std::max(range_m, 0.0);
  return range_m < options_.min_range_m ? kTooClose : range_m;
}

double SensorModel::strength(double range_m, double cos_incidence, const Material& material) const {
  return material.reflectivity * cos_incidence * reach_scale_m2_ / (range_m * range_m);
}

double SensorModel::sigma_m(double range_m, double cos_incidence, const Material& material) const {
  const double far_m = options_.noise.sigma_ratio * range_m;
  double variance = options_.noise_sigma_m * options_.noise_sigma_m + far_m * far_m;
  if (options_.noise.weak_ratio > 0.0 && std::isfinite(reach_scale_m2_)) {
    const double seen = std::max(strength(range_m, cos_incidence, material), kSurelyLost);
    variance *= 1.0 + options_.noise.weak_ratio / seen;
  }
  return options_.effects.noise * std::sqrt(variance + material.roughness_m * material.roughness_m);
}

double SensorModel::bias_m(double range_m, double cos_incidence, const Material& material) const {
  const double wave =
      options_.bias.cyclic_m == 0.0 ? 0.0 : sine_of_turns(range_m / options_.bias.cyclic_period_m);
  return bias_of_wave_m(wave, cos_incidence, material);
}

double SensorModel::bias_of_wave_m(double wave, double cos_incidence, const Material& material) const {
  const BiasOptions& bias = options_.bias;
  const double sum_m = bias.offset_m + bias.dark_m * (1.0 - material.reflectivity) +
                       bias.grazing_m * (1.0 - cos_incidence) + bias.cyclic_m * wave;
  return options_.effects.bias * sum_m;
}

double SensorModel::loss_probability(double range_m, double cos_incidence, const Material& material) const {
  if (options_.effects.dropout == 0.0) return 0.0;
  if (material.glass && cos_incidence < cos_glass_cone_) return std::min(options_.effects.dropout, 1.0);
  if (!std::isfinite(reach_scale_m2_)) return 0.0;
  const double seen = strength(range_m, cos_incidence, material);
  const double lost = (kSurelySeen - seen) / (kSurelySeen - kSurelyLost);
  return std::clamp(options_.effects.dropout * std::max(lost, 0.0), 0.0, 1.0);
}

}  // namespace scanbed::sim
