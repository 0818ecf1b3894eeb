// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <string>

#include "core/geometry/angles.hpp"
#include "scenarios/load/sections.hpp"
#include "scenarios/load/table.hpp"

namespace scanbed::scenarios {
namespace {

constexpr Allowed kSpeed{.least = 0.0, .greatest = 5.0, .open = true};
constexpr Allowed kTurnRate_deg{.least = 0.0, .greatest = 360.0, .open = true};
constexpr Allowed kWait{.least = 0.0, .greatest = 86'400.0};

sim::DriveStep load_drive_step(const Value& value) {
  Table step(value);
  const auto wait = step.take("wait");
  const auto turn = step.take("turn_deg");
  const auto go = step.take("go");
  step.finish();
  if (wait.has_value() + turn.has_value() + go.has_value() != 1) {
    value.refuse("a step is exactly one of wait, turn_deg and go");
  }
  if (wait) return sim::Wait{wait->number(kWait)};
  if (turn) return sim::Turn{radians(turn->number(kAngle_deg))};
  return sim::Go{go->number(kCoordinate)};
}

}  // namespace

void load_robot(const Value& value, sim::Robot& robot) {
  // The preset's numbers are those of sim::Robot.
  static const std::array<std::string, 1> kRobots = {"pioneer2dx"};
  Table table(value);
  if (const auto use = table.take("use")) use->choice(kRobots);
  if (const auto pose = table.take("pose")) robot.X_WR = pose->pose();
  if (const auto laser = table.take("laser")) robot.X_RS = laser->pose();
  robot.speed_m_per_s = table.number("speed", robot.speed_m_per_s, kSpeed);
  robot.radius_m = table.number("radius", robot.radius_m, kLength);
  const double turn_rate_deg = degrees(robot.turn_rad_per_s);
  robot.turn_rad_per_s = radians(table.number("turn_rate_deg", turn_rate_deg, kTurnRate_deg));
  if (const auto drive = table.take("drive")) {
    for (const Value& step : drive->items()) robot.drive.push_back(load_drive_step(step));
  }
  table.finish();
}

}  // namespace scanbed::scenarios
