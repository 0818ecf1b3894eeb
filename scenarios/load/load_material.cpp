// SPDX-License-Identifier: MIT
#include "scenarios/load/sections.hpp"
#include "scenarios/load/table.hpp"
#include "sim/world/materials.hpp"

namespace scanbed::scenarios {
namespace {

constexpr Allowed kReflectivity{.least = 0.0, .greatest = 1.0, .open = true};
constexpr Allowed kRoughness_m{.least = 0.0, .greatest = 1.0};

sim::Material named(const Value& value) {
  static const std::vector<std::string> kNames = sim::material_names();
  return sim::material_named(kNames[value.choice(kNames)]);
}

}  // namespace

sim::Material load_material(const Value& value) {
  if (value.node().kind == TreeNode::Kind::kScalar) return named(value);
  Table table(value);
  sim::Material material;
  if (const auto use = table.take("use")) material = named(*use);
  material.reflectivity = table.number("reflectivity", material.reflectivity, kReflectivity);
  material.glass = table.flag("glass", material.glass);
  material.roughness_m = table.number("roughness", material.roughness_m, kRoughness_m);
  table.finish();
  return material;
}

}  // namespace scanbed::scenarios
