// SPDX-License-Identifier: MIT
#include <array>
#include <limits>
#include <string>

#include "core/geometry/angles.hpp"
#include "scenarios/load/sections.hpp"
#include "scenarios/load/table.hpp"
#include "sim/world/body.hpp"

namespace scanbed::scenarios {
namespace {

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
  path.round_m = table.number("round", 0.0, {.least = 0.0, .greatest = sim::kFarthest_m});
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
  if (const auto material = table.take("material")) tow.material = load_material(*material);
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

// "forever" or a time.
double load_rest(const Value& value) {
  return value.is("forever") ? std::numeric_limits<double>::infinity() : value.number(kStart);
}

sim::Stop load_stop(const Value& value) {
  Table table(value);
  sim::Stop stop;
  stop.at_m = table.need("at").number({.least = 0.0, .greatest = 1e6});
  if (const auto rest = table.take("for")) stop.for_s = load_rest(*rest);
  stop.turn_rad = radians(table.number("turn_deg", 0.0, {.least = -360.0, .greatest = 360.0}));
  table.finish();
  return stop;
}

// A person's body is drawn from seed and id; each of its sizes may still be given.
void load_body(Table& table, const Scenario& scenario, sim::Walker& walker) {
  static const std::array<std::string, 3> kPersons = {"woman", "man", "child"};
  static const std::array<std::string, 3> kClothes = {"bare", "trousers", "skirt"};
  const auto person = table.take("person");
  const auto clothing = table.take("clothing");
  if (clothing && !person) clothing->refuse("goes with person, whose legs it covers");
  if (person) {
    const auto kind = static_cast<sim::Person>(person->choice(kPersons));
    const auto worn =
        clothing ? static_cast<sim::Clothing>(clothing->choice(kClothes)) : sim::Clothing::kBare;
    give_body(walker, draw_body(kind, scenario.seed, walker.id), worn, scenario.world.robot.laser_height_m);
  }
  walker.speed_m_per_s = table.number("speed", walker.speed_m_per_s, kSpeed);
  walker.leg_radius_m = table.number("leg_radius", walker.leg_radius_m, kBodySize);
  walker.leg_length_m = table.number("leg_length", walker.leg_length_m, kBodySize);
  walker.step_width_m = table.number("step_width", walker.step_width_m, kBodySize);
  walker.height_m = table.number("height", walker.height_m, kBodySize);
  if (const auto material = table.take("material")) walker.material = load_material(*material);
}

sim::Walker load_walker(const Value& value, const Scenario& scenario) {
  static const std::array<std::string, 1> kPresets = {"walker"};
  Table table(value);
  sim::Walker walker;
  walker.id = table.need("id").text();
  table.need("use").choice(kPresets);
  load_body(table, scenario, walker);
  if (const auto start = table.take("start")) walker.start_s = load_start(*start);
  walker.lateral_m = table.number("lateral", walker.lateral_m, {.least = -10.0, .greatest = 10.0});
  walker.avoids = table.flag("avoids", walker.avoids);
  if (const auto stops = table.take("stops")) {
    for (const Value& stop : stops->items()) walker.stops.push_back(load_stop(stop));
  }
  const Value path = table.need("path");
  const auto tows = table.take("tows");
  table.finish();
  walker.path = load_path(path);
  if (tows) walker.tow = load_tow(*tows);
  return walker;
}

}  // namespace

void load_actors(const Value& value, Scenario& scenario) {
  for (const Value& item : value.items()) scenario.world.walkers.push_back(load_walker(item, scenario));
}

}  // namespace scanbed::scenarios
