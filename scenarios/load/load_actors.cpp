// SPDX-License-Identifier: MIT
#include <array>
#include <string>

#include "scenarios/load/sections.hpp"
#include "scenarios/load/table.hpp"

namespace scanbed::scenarios {
namespace {

constexpr Allowed kSpeed{.least = 0.0, .greatest = 5.0, .open = true};
constexpr Allowed kBodySize{.least = 0.0, .greatest = 3.0, .open = true};
constexpr Allowed kStart{.least = 0.0, .greatest = 86'400.0};
constexpr Allowed kMass_kg{.least = 0.0, .greatest = 1'000.0, .open = true};
constexpr Allowed kFriction{.least = 0.0, .greatest = 10.0};

sim::Path load_path(const Value& value) {
  static const std::array<std::string, 2> kEndings = {"stand", "leave"};
  Table table(value);
  const auto loop = table.take("loop");
  const auto line = table.take("line");
  sim::Path path;
  path.round_m = table.number("round", 0.0, {.least = 0.0, .greatest = kFarthest_m});
  const auto then = table.take("then");
  if (then) path.leave = then->choice(kEndings) == 1;
  table.finish();
  if (loop.has_value() == line.has_value()) value.refuse("a path is exactly one of loop and line");
  if (loop && then) then->refuse("a loop has no end; it goes with line");
  path.loop = loop.has_value();
  path.points_m = (loop ? *loop : *line).points_m(2);
  return path;
}

sim::Tow load_tow(const Value& value) {
  Table table(value);
  sim::Tow tow;
  tow.id = table.need("id").text();
  tow.label = table.text("label", tow.label);
  tow.rope_m = table.number("rope", tow.rope_m, kLength);
  tow.mass_kg = table.number("mass", tow.mass_kg, kMass_kg);
  tow.friction = table.number("friction", tow.friction, kFriction);
  const Value shape = table.need("cylinder");
  table.finish();
  Table cylinder(shape);
  tow.radius_m = cylinder.need("r").number(kLength);
  tow.height_m = cylinder.number("height", tow.height_m, kLength);
  cylinder.finish();
  return tow;
}

double load_start(const Value& value) {
  Table table(value);
  const double after_s = table.need("after").number(kStart);
  table.finish();
  return after_s;
}

sim::Walker load_walker(const Value& value) {
  static const std::array<std::string, 1> kPresets = {"walker"};
  Table table(value);
  sim::Walker walker;
  walker.id = table.need("id").text();
  table.need("use").choice(kPresets);
  walker.speed_m_per_s = table.number("speed", walker.speed_m_per_s, kSpeed);
  walker.leg_radius_m = table.number("leg_radius", walker.leg_radius_m, kBodySize);
  walker.leg_length_m = table.number("leg_length", walker.leg_length_m, kBodySize);
  walker.step_width_m = table.number("step_width", walker.step_width_m, kBodySize);
  walker.height_m = table.number("height", walker.height_m, kBodySize);
  if (const auto start = table.take("start")) walker.start_s = load_start(*start);
  const Value path = table.need("path");
  const auto tows = table.take("tows");
  table.finish();
  walker.path = load_path(path);
  if (tows) walker.tow = load_tow(*tows);
  return walker;
}

}  // namespace

void load_actors(const Value& value, std::vector<sim::Walker>& walkers) {
  for (const Value& item : value.items()) walkers.push_back(load_walker(item));
}

}  // namespace scanbed::scenarios
