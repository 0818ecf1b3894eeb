// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/geometry/angles.hpp"
#include "core/scan/lms_word.hpp"
#include "core/text/number_text.hpp"
#include "scenarios/load/sections.hpp"
#include "scenarios/load/sensor_effects.hpp"
#include "scenarios/load/table.hpp"
#include "sim/sensor/sensor_presets.hpp"

namespace scanbed::scenarios {
namespace {

constexpr double kMaxHeight_m = 2.0;
constexpr Allowed kTilt_deg{.least = -80.0, .greatest = 80.0};

// The scanner's driver asks for no more than this, even where the link would carry it.
struct Link {
  double baud;
  double least_period_s;
};
constexpr std::array<Link, 2> kLinks = {{{38'400.0, 0.2}, {500'000.0, 1.0 / 37.5}}};
const std::array<std::string, 2> kLinkNames = {"rs422_38400", "rs422_500k"};

// One of a few numbers: the sensor has no other settings.
double one_of(const Value& value, std::span<const double> allowed, std::string_view names) {
  const double number = value.number();
  for (const double candidate : allowed) {
    if (number == candidate) return number;
  }
  value.refuse(std::string("the sensor has no such setting; allowed: ").append(names));
}

// The LMS has three steps and two fields of view; other sensors are free to differ from their preset.
void load_angles(Table& sensor, sim::SensorOptions& lms) {
  const auto step = sensor.take("resolution_deg");
  const auto fov = sensor.take("fov_deg");
  if (lms.interlace) {
    if (step) lms.step_rad = radians(one_of(*step, std::array{0.25, 0.5, 1.0}, "0.25, 0.5, 1"));
    if (fov) lms.fov_rad = radians(one_of(*fov, std::array{100.0, 180.0}, "100, 180"));
    return;
  }
  if (step) lms.step_rad = radians(step->number({.least = 0.02, .greatest = 10.0}));
  if (fov) lms.fov_rad = radians(fov->number({.least = 1.0, .greatest = 360.0}));
  // A whole number of steps, as near as possible.
  lms.fov_rad = std::floor(lms.fov_rad / lms.step_rad + 1e-6) * lms.step_rad;
}

void load_timing(Table& sensor, sim::SensorOptions& lms) {
  const auto link = sensor.take("link");
  const auto period = sensor.take("period");
  if (link && period) period->refuse("the link says already how often there are scans");
  if (link) {
    const Link& chosen = kLinks[link->choice(kLinkNames)];
    lms.scan_period_s = std::max(chosen.least_period_s, sim::lms_scan_period_s(lms, chosen.baud));
  }
  const double shortest_s = lms.num_rotations() * lms.rotation_s;
  if (period) lms.scan_period_s = period->number({.least = shortest_s, .greatest = 60.0});
  lms.scan_period_s = std::max(lms.scan_period_s, shortest_s);
}

void load_mount(Table& sensor, sim::Robot& robot) {
  robot.laser_height_m =
      sensor.number("height", robot.laser_height_m, {.least = 0.0, .greatest = kMaxHeight_m, .open = true});
  robot.laser_pitch_rad = radians(sensor.number("pitch_deg", degrees(robot.laser_pitch_rad), kTilt_deg));
  robot.laser_roll_rad = radians(sensor.number("roll_deg", degrees(robot.laser_roll_rad), kTilt_deg));
}

// Farther than its words reach no sensor of them sees, whatever is asked for.
void load_max_range(Table& sensor, sim::SensorOptions& lms) {
  const auto value = sensor.take("max_range");
  if (!value) return;
  lms.max_range_m = value->number(kLength);
  const double greatest_m = lms_max_range_m(lms.unit, lms.word_bits);
  if (lms.max_range_m <= greatest_m) return;
  value->refuse(fmt::format("{} m are more than this sensor's words can tell; allowed: up to {} m{}",
                            number_text(lms.max_range_m), number_text(greatest_m),
                            lms.unit == sim::RangeUnit::kMillimetre ? ", or unit: cm" : ""));
}

}  // namespace

void load_sensor(const Value& value, Scenario& scenario) {
  static const std::vector<std::string> kSensors = sim::sensor_preset_names();
  static const std::array<std::string, 2> kUnits = {"mm", "cm"};
  sim::SensorOptions& lms = scenario.lms;
  Table sensor(value);
  if (const auto use = sensor.take("use")) lms = sim::sensor_preset(kSensors[use->choice(kSensors)]);
  const bool was_interlaced = lms.interlace;
  load_angles(sensor, lms);
  lms.interlace = sensor.flag("interlace", was_interlaced);
  if (const auto unit = sensor.take("unit")) {
    lms.unit = unit->choice(kUnits) == 0 ? sim::RangeUnit::kMillimetre : sim::RangeUnit::kCentimetre;
  }
  load_timing(sensor, lms);
  lms.min_range_m = sensor.number("min_range", lms.min_range_m, {.least = 0.0, .greatest = sim::kFarthest_m});
  load_max_range(sensor, lms);
  load_effects(sensor, lms);
  load_mount(sensor, scenario.world.robot);
  sensor.finish();
}

}  // namespace scanbed::scenarios
