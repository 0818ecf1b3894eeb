// SPDX-License-Identifier: MIT
#include "sim/world/materials.hpp"

#include <array>

#include "core/errors/input_error.hpp"

namespace scanbed::sim {
namespace {

struct NamedMaterial {
  std::string_view name;
  Material material;
};

constexpr std::array<NamedMaterial, 11> kMaterials = {{
    {"default", {}},
    {"white_paper", {.reflectivity = 0.8}},
    {"grey_cardboard", {.reflectivity = 0.2}},
    {"black_cardboard", {.reflectivity = 0.1}},
    {"raw_wood", {.reflectivity = 0.4}},
    {"grey_pvc", {.reflectivity = 0.5}},
    {"steel", {.reflectivity = 1.0}},
    {"glass", {.reflectivity = 0.9, .glass = true}},
    {"bark", {.reflectivity = 0.3, .roughness_m = 0.010}},
    {"dark_cloth", {.reflectivity = 0.08, .roughness_m = 0.006}},
    {"light_cloth", {.reflectivity = 0.6, .roughness_m = 0.006}},
}};

}  // namespace

Material material_named(std::string_view name) {
  std::string known;
  for (const NamedMaterial& candidate : kMaterials) {
    if (candidate.name == name) return candidate.material;
    known += (known.empty() ? "" : ", ") + std::string(candidate.name);
  }
  throw InputError("material: no '" + std::string(name) + "'; allowed: " + known);
}

std::vector<std::string> material_names() {
  std::vector<std::string> names;
  names.reserve(kMaterials.size());
  for (const NamedMaterial& candidate : kMaterials) names.emplace_back(candidate.name);
  return names;
}

}  // namespace scanbed::sim
