// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <iterator>
#include <string>

#include "scenarios/load/sections.hpp"
#include "scenarios/load/table.hpp"
#include "sim/world/furniture.hpp"

namespace scanbed::scenarios {
namespace {

constexpr Allowed kHeight{.least = 0.0, .greatest = 100.0};

sim::Cylinder load_cylinder(const Value& value) {
  Table table(value);
  sim::Cylinder cylinder;
  cylinder.center_m = table.need("at").point_m();
  cylinder.radius_m = table.need("r").number(kLength);
  table.finish();
  return cylinder;
}

sim::Box load_box(const Value& value) {
  Table table(value);
  sim::Box box;
  box.X_WB = table.need("at").pose();
  const std::vector<Value> size = table.need("size").items(2);
  box.size_m = {size[0].number(kLength), size[1].number(kLength)};
  table.finish();
  return box;
}

// What all solids share: id, label, how high they reach, how they answer the laser.
sim::Solid load_frame(Table& table, std::string_view default_label) {
  sim::Solid solid;
  solid.id = table.need("id").text();
  solid.label = table.text("label", std::string(default_label));
  solid.bottom_m = table.number("bottom", solid.bottom_m, kHeight);
  const auto top = table.take("top");
  if (top) solid.top_m = top->number(kHeight);
  if (solid.top_m <= solid.bottom_m) {
    (top ? *top : table.value()).refuse(fmt::format("must be above the bottom, {}", solid.bottom_m));
  }
  if (const auto material = table.take("material")) solid.material = load_material(*material);
  return solid;
}

void append(std::vector<sim::Solid> parts, std::vector<sim::Solid>& solids) {
  std::move(parts.begin(), parts.end(), std::back_inserter(solids));
}

struct BenchFeet {
  double radius_m = 0.0;
  double apart_m = 0.0;  // between their axes
};

BenchFeet load_feet(const Value& value) {
  Table table(value);
  BenchFeet feet;
  feet.radius_m = table.need("r").number(kLength);
  const Value apart = table.need("apart");
  feet.apart_m = apart.number(kLength);
  table.finish();
  if (feet.apart_m <= 2.0 * feet.radius_m) apart.refuse("the feet overlap; allowed: > 2 r");
  return feet;
}

// A bench is two short cylinders that carry a seat; the laser usually looks below the seat.
void load_bench(Table& table, std::vector<sim::Solid>& solids) {
  const std::string id = table.need("id").text();
  const std::string label = table.text("label", "bench");
  const Pose2 X_WB = table.need("at").pose();
  const double seat_z_m = table.number("seat_z", 0.45, {.least = 0.0, .greatest = 2.0, .open = true});
  const BenchFeet feet = load_feet(table.need("feet"));
  table.finish();
  append(sim::bench_parts({id, label, X_WB, feet.radius_m, feet.apart_m, seat_z_m}), solids);
}

// A chair is a square seat on four thin square legs; between them the laser looks through.
void load_chair(Table& table, std::vector<sim::Solid>& solids) {
  const std::string id = table.need("id").text();
  const std::string label = table.text("label", "chair");
  const Pose2 X_WC = table.need("at").pose();
  const double size_m = table.number("size", 0.42, {.least = 0.1, .greatest = 2.0});
  const double leg_m = table.number("leg", 0.03, {.least = 0.0, .greatest = 0.5 * size_m, .open = true});
  const double seat_z_m = table.number("seat_z", 0.45, {.least = 0.0, .greatest = 2.0, .open = true});
  table.finish();
  append(sim::chair_parts({id, label, X_WC, size_m, leg_m, seat_z_m}), solids);
}

// Things of several solids, by what they are.
void load_furniture(const Value& use, Table& table, std::vector<sim::Solid>& solids) {
  static const std::array<std::string, 2> kPresets = {"bench", "chair"};
  return use.choice(kPresets) == 0 ? load_bench(table, solids) : load_chair(table, solids);
}

struct ShapeKey {
  const char* key;
  const char* default_label;
};
constexpr std::array kShapeKeys = {ShapeKey{"walls", "wall"}, ShapeKey{"cylinder", "cylinder"},
                                   ShapeKey{"box", "box"}, ShapeKey{"polygon", "polygon"},
                                   ShapeKey{"map", "wall"}};

sim::SolidShape load_shape(const Value& shape, Table& table) {
  if (shape.name() == "cylinder") return load_cylinder(shape);
  if (shape.name() == "box") return load_box(shape);
  if (shape.name() == "polygon") return sim::Polygon{shape.points_m(3)};
  return sim::WallChain{shape.points_m(2), table.flag("closed", false)};
}

void load_solid(const Value& value, std::vector<sim::Solid>& solids) {
  Table table(value);
  if (const auto use = table.take("use")) return load_furniture(*use, table, solids);
  std::optional<Value> shape;
  const char* default_label = "";
  for (const ShapeKey& candidate : kShapeKeys) {
    const std::optional<Value> found = table.take(candidate.key);
    if (!found) continue;
    if (shape) found->refuse(fmt::format("a second shape beside '{}'", shape->name()));
    shape = found;
    default_label = candidate.default_label;
  }
  sim::Solid solid = load_frame(table, default_label);
  const bool is_map = shape && shape->name() == "map";
  if (shape && !is_map) solid.shape = load_shape(*shape, table);
  // Unknown keys first: a misspelt shape is better told by its nearest name.
  table.finish();
  if (!shape) {
    value.refuse("no shape; one of walls, cylinder, box, polygon, map, use: bench, use: chair");
  }
  if (is_map) return load_map(*shape, solid, solids);
  solids.push_back(std::move(solid));
}

}  // namespace

void load_solids(const Value& value, std::vector<sim::Solid>& solids) {
  for (const Value& item : value.items()) load_solid(item, solids);
}

}  // namespace scanbed::scenarios
