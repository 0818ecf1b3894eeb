// SPDX-License-Identifier: MIT
#include "sim/sensor/sensor_options.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/errors/input_error.hpp"
#include "core/text/number_text.hpp"

namespace scanbed::sim {
namespace {

constexpr double kTolerance_rad = 1e-9;  // degrees come as rounded radians

bool is_near(double a_rad, double b_rad) {
  return std::abs(a_rad - b_rad) <= kTolerance_rad;
}

void require_in(double value, double least, double greatest, const std::string& name) {
  require(value >= least && value <= greatest, name, value,
          "[" + number_text(least) + ", " + number_text(greatest) + "]");
}

void check_beams(const SensorOptions& s) {
  const bool offered = is_near(s.step_rad, radians(0.25)) || is_near(s.step_rad, radians(0.5)) ||
                       is_near(s.step_rad, radians(1.0));
  if (s.interlace) require(offered, "sensor.step_deg", degrees(s.step_rad), "0.25, 0.5 or 1");
  require(s.step_rad >= radians(0.01) - kTolerance_rad && s.step_rad <= radians(10.0), "sensor.step_deg",
          degrees(s.step_rad), "[0.01, 10]");
  require(s.fov_rad > 0.0 && s.fov_rad <= 2.0 * kPi + kTolerance_rad, "sensor.fov_deg", degrees(s.fov_rad),
          "(0, 360]");
  const double covered_rad = (s.num_beams() - 1) * s.step_rad;
  require(std::abs(s.fov_rad - covered_rad) <= 1e-6 * s.step_rad + kTolerance_rad, "sensor.fov_deg",
          degrees(s.fov_rad), "a multiple of sensor.step_deg");
}

void check_times(const SensorOptions& s) {
  require(s.rotation_s > 0.0 && s.rotation_s <= 10.0, "sensor.rotation_s", s.rotation_s, "(0, 10]");
  const double sweep_s = s.num_rotations() * s.rotation_s;
  require(s.scan_period_s >= sweep_s * (1.0 - 1e-9) && s.scan_period_s <= 3600.0, "sensor.scan_period_s",
          s.scan_period_s,
          number_text(sweep_s) + " (" + std::to_string(s.num_rotations()) + " rotations) to 3600");
  require(s.max_sector_s > 0.0 && s.max_sector_s <= 10.0, "sensor.max_sector_s", s.max_sector_s, "(0, 10]");
}

void check_ranges(const SensorOptions& s) {
  require_in(s.word_bits, 13, 15, "sensor.word_bits");
  require(s.max_range_m > 0.0, "sensor.max_range_m", s.max_range_m, "> 0");
  require(s.min_range_m >= 0.0 && s.min_range_m < s.range_limit_m(), "sensor.min_range_m", s.min_range_m,
          "[0, " + number_text(s.range_limit_m()) + "), below the greatest range");
}

void check_errors(const SensorOptions& s) {
  require_in(s.noise_sigma_m, 0, 1, "sensor.noise_sigma_m");
  require_in(s.noise.sigma_ratio, 0, 1, "sensor.noise.sigma_ratio");
  require_in(s.noise.weak_ratio, 0, 100, "sensor.noise.weak_ratio");
  require_in(s.bias.offset_m, -1, 1, "sensor.bias.offset_m");
  require_in(s.bias.cyclic_m, -1, 1, "sensor.bias.cyclic_m");
  require_in(s.bias.cyclic_period_m, 0.01, 1000, "sensor.bias.cyclic_period_m");
  require_in(s.bias.dark_m, -1, 1, "sensor.bias.dark_m");
  require_in(s.bias.grazing_m, -1, 1, "sensor.bias.grazing_m");
  require(s.dropout.reach_m > 0.0, "sensor.dropout.reach_m", s.dropout.reach_m, "> 0");
  require_in(s.dropout.glass_cone_rad, 0, kPi / 2, "sensor.dropout.glass_cone_rad");
  require_in(s.dazzle.probability, 0, 1, "sensor.dazzle.probability");
  require_in(s.dazzle.glint_rad, 0, kPi / 2, "sensor.dazzle.glint_rad");
}

void check_spot(const SpotOptions& spot) {
  require_in(spot.diameter_m, 0, 0.2, "sensor.spot.diameter_m");
  require_in(spot.divergence_rad, 0, 0.1, "sensor.spot.divergence_rad");
  require(spot.num_rays >= 3 && spot.num_rays <= 9 && spot.num_rays % 2 == 1, "sensor.spot.num_rays",
          spot.num_rays, "3, 5, 7 or 9");
  require_in(spot.pulse_m, 0, 100, "sensor.spot.pulse_m");
}

void check_scales(const EffectScales& effects) {
  require_in(effects.noise, 0, 100, "sensor.effects.noise");
  require_in(effects.bias, 0, 100, "sensor.effects.bias");
  require_in(effects.spot, 0, 10, "sensor.effects.spot");
  require_in(effects.dropout, 0, 100, "sensor.effects.dropout");
  require_in(effects.dazzle, 0, 100, "sensor.effects.dazzle");
  require(effects.sweep == 0.0 || effects.sweep == 1.0, "sensor.effects.sweep", effects.sweep, "0 or 1");
}

}  // namespace

int SensorOptions::num_beams() const {
  return static_cast<int>(std::lround(fov_rad / step_rad)) + 1;
}

int SensorOptions::num_rotations() const {
  return interlace ? static_cast<int>(std::lround(radians(1.0) / step_rad)) : 1;
}

double SensorOptions::range_limit_m() const {
  return std::min(max_range_m, lms_max_range_m(unit, word_bits));
}

double SensorOptions::beam_period_s() const {
  return effects.sweep * rotation_s * num_rotations() * step_rad / (2.0 * kPi);
}

double SensorOptions::spot_diameter_m(double range_m) const {
  return effects.spot * (spot.diameter_m + spot.divergence_rad * range_m);
}

void SensorOptions::validate() const {
  check_beams(*this);
  check_times(*this);
  check_ranges(*this);
  check_errors(*this);
  check_spot(spot);
  check_scales(effects);
}

SensorOptions ideal_sensor(SensorOptions options) {
  options.exact_ranges = true;
  options.interlace = false;
  options.effects = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  return options;
}

int lms_telegram_bytes(int num_beams) {
  return 2 * num_beams + 10;
}

double lms_scan_period_s(const SensorOptions& options, double link_baud) {
  require(link_baud >= 300.0 && link_baud <= 1e9, "sensor.link_baud", link_baud, "[300, 1e9]");
  constexpr double kBitsPerByte = 10.0;  // 8N1
  return std::max(lms_telegram_bytes(options.num_beams()) * kBitsPerByte / link_baud,
                  options.num_rotations() * options.rotation_s);
}

}  // namespace scanbed::sim
