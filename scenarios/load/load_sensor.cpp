// SPDX-License-Identifier: MIT
#include <array>
#include <string>

#include "core/geometry/angles.hpp"
#include "scenarios/load/sections.hpp"
#include "scenarios/load/table.hpp"

namespace scanbed::scenarios {
namespace {

constexpr double kMaxHeight_m = 2.0;
constexpr double kMaxSigma_m = 0.5;

// 732 bytes a scan of 361 beams: 190.6 ms at 38400 baud; 500 kbaud keeps up with every scan of the mirror.
constexpr std::array kLinkPeriods_s = {0.2, 1.0 / 37.5};
const std::array<std::string, 2> kLinks = {"rs422_38400", "rs422_500k"};

// One of a few numbers: the sensor has no other settings.
double one_of(const Value& value, std::span<const double> allowed, std::string_view names) {
  const double number = value.number();
  for (const double candidate : allowed) {
    if (number == candidate) return number;
  }
  value.refuse(std::string("the sensor has no such setting; allowed: ").append(names));
}

void load_noise(const Value& value, sim::LmsOptions& lms) {
  Table noise(value);
  lms.noise_sigma_m = noise.number("sigma", lms.noise_sigma_m, {.least = 0.0, .greatest = kMaxSigma_m});
  noise.finish();
}

}  // namespace

void load_sensor(const Value& value, Scenario& scenario) {
  static const std::array<std::string, 1> kSensors = {"sick_lms200"};
  static const std::array<std::string, 2> kUnits = {"mm", "cm"};
  sim::LmsOptions& lms = scenario.lms;
  Table sensor(value);
  if (const auto use = sensor.take("use")) use->choice(kSensors);
  if (const auto step = sensor.take("resolution_deg")) {
    lms.step_rad = radians(one_of(*step, std::array{0.25, 0.5, 1.0}, "0.25, 0.5, 1"));
  }
  if (const auto fov = sensor.take("fov_deg")) {
    lms.fov_rad = radians(one_of(*fov, std::array{100.0, 180.0}, "100, 180"));
  }
  if (const auto unit = sensor.take("unit")) {
    lms.unit = unit->choice(kUnits) == 0 ? sim::RangeUnit::kMillimetre : sim::RangeUnit::kCentimetre;
  }
  if (const auto link = sensor.take("link")) lms.scan_period_s = kLinkPeriods_s[link->choice(kLinks)];
  if (const auto noise = sensor.take("noise")) load_noise(*noise, lms);
  lms.interlace = sensor.flag("interlace", lms.interlace);
  double& height_m = scenario.world.robot.laser_height_m;
  height_m = sensor.number("height", height_m, {.least = 0.0, .greatest = kMaxHeight_m, .open = true});
  sensor.finish();
}

}  // namespace scanbed::scenarios
