// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>

#include "core/geometry/angles.hpp"
#include "scenarios/load/sections.hpp"
#include "scenarios/load/table.hpp"

namespace scanbed::scenarios {
namespace {

constexpr Allowed kTurnRate_deg{.least = 0.0, .greatest = 360.0, .open = true};
constexpr Allowed kWait{.least = 0.0, .greatest = 86'400.0};
constexpr Allowed kRounds{.least = 1.0, .greatest = 1'000.0};

sim::DriveStep load_drive_path(const Value& value) {
  Table table(value);
  const auto line = table.take("line");
  const auto loop = table.take("loop");
  const auto rounds = table.take("rounds");
  const auto round = table.take("round");
  table.finish();
  if (loop.has_value() == line.has_value()) value.refuse("a path is exactly one of loop and line");
  if (line && rounds) rounds->refuse("a line is driven once; it goes with loop");
  sim::FollowPath path;
  path.points_m = (loop ? *loop : *line).points_m(loop ? 2 : 1);
  if (loop) path.rounds = 1;
  if (rounds) path.rounds = static_cast<int>(rounds->count(kRounds));
  if (round) path.round_m = round->number({.least = 0.0, .greatest = sim::kFarthest_m});
  return path;
}

sim::DriveStep load_follow(const Value& value) {
  Table table(value);
  sim::FollowLegs follow;
  follow.distance_m = table.number("distance", follow.distance_m, kLength);
  follow.for_s = table.number("for", follow.for_s, {.least = 0.0, .greatest = 86'400.0, .open = true});
  follow.within_m = table.number("within", follow.within_m, kLength);
  follow.patience_s = table.number("patience", follow.patience_s, {.least = 0.0, .greatest = 60.0});
  table.finish();
  return follow;
}

using LoadStep = sim::DriveStep (*)(const Value& value);
struct DriveKey {
  const char* key;
  LoadStep load;
};
constexpr std::array<DriveKey, 5> kDriveKeys = {
    {{"wait", [](const Value& value) -> sim::DriveStep { return sim::Wait{value.number(kWait)}; }},
     {"turn_deg",
      [](const Value& value) -> sim::DriveStep { return sim::Turn{radians(value.number(kAngle_deg))}; }},
     {"go", [](const Value& value) -> sim::DriveStep { return sim::Go{value.number(kCoordinate)}; }},
     {"path", load_drive_path},
     {"follow", load_follow}}};

sim::DriveStep load_drive_step(const Value& value) {
  Table table(value);
  std::optional<Value> found;
  LoadStep load = nullptr;
  int num_found = 0;
  for (const DriveKey& candidate : kDriveKeys) {
    const std::optional<Value> step = table.take(candidate.key);
    if (!step) continue;
    ++num_found;
    found = step;
    load = candidate.load;
  }
  table.finish();
  if (num_found != 1) value.refuse("a step is exactly one of wait, turn_deg, go, path and follow");
  return load(*found);
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
