// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/random/philox.hpp"
#include "sim/sensor/ideal_returns.hpp"
#include "sim/sensor/sensor_options.hpp"
#include "sim/world/world.hpp"

namespace scanbed::sim {

/// What a sensor makes of ideal returns: which of the echoes in a spot it measures, whether it is dazzled or
/// the echo too weak, bias, noise, and the nearest step, through the words of its protocol.
///
/// Random numbers are drawn by (seed, scan, beam): the same for any order of scans and number of workers, and
/// with any compiler.
class SensorModel {
 public:
  /// @param materials  by object, as IdealReturns counts them.
  /// @pre the options validate.
  SensorModel(const SensorOptions& options, std::uint64_t seed, std::vector<Material> materials);

  /// Writes the ranges of one scan over `range_m`, decoded from words unless the sensor's ranges are exact:
  /// kNoEcho without an echo and beyond the greatest range, kInvalid where dazzled; where too close,
  /// kTooClose of exact ranges and kInvalid of words, which have no code for it. What noise takes below 0 is
  /// 0.
  void measure(const IdealReturns& returns, std::int64_t scan, std::vector<double>& range_m);

  /// Standard deviation of the noise on a clean echo, in closed form (see NoiseOptions).
  double sigma_m(double range_m, double cos_incidence, const Material& material) const;

  /// Systematic error of a clean echo, in closed form (see BiasOptions).
  double bias_m(double range_m, double cos_incidence, const Material& material) const;

  /// Probability that a clean echo is lost (see DropoutOptions).
  double loss_probability(double range_m, double cos_incidence, const Material& material) const;

 private:
  /// What the sensor takes for the echo of a beam.
  struct Echo {
    double range_m;
    double cos_incidence;
    const Material* material;  ///< nullptr: there is none
  };
  Echo axis_echo(const IdealReturns& returns, int beam) const;
  Echo spot_echo(const IdealReturns& returns, const SplitSpot& spot);
  void draw(int num_beams);
  void make_waves();
  bool is_dazzled(const Echo& echo, int beam) const;
  double reading_m(int beam) const;
  double bias_of_wave_m(double wave, double cos_incidence, const Material& material) const;
  double strength(double range_m, double cos_incidence, const Material& material) const;

  SensorOptions options_;
  RandomSource random_;
  std::vector<Material> materials_;
  double reach_scale_m2_;  ///< reach^2 / 10 %; infinite where no echo is too weak
  double cos_glass_cone_;
  double cos_glint_;
  double range_limit_m_;
  bool any_glass_;
  std::vector<SpotReturn> sorted_;  ///< scratch: a spot's rays by range
  std::int64_t scan_ = 0;           ///< that is measured
  // Scratch, by beam; the random numbers in whole blocks.
  std::vector<Echo> echoes_;
  std::vector<double> wave_;  ///< sine of the bias over range; empty where there is none
  std::vector<double> gaussian_;
  std::vector<std::uint32_t> loss_word_;
};

}  // namespace scanbed::sim
