// SPDX-License-Identifier: MIT
#include "sim/spatial/appearance.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace scanbed::sim {
namespace {

const Rgb kGrey{0.68, 0.69, 0.71};
const Rgb kConcrete{0.62, 0.60, 0.57};

}  // namespace

Rgb solid_color(const Solid& solid) {
  static const std::array<std::pair<std::string_view, Rgb>, 7> kByLabel{{
      {"wall", {0.86, 0.84, 0.79}},
      {"column", {0.80, 0.66, 0.48}},
      {"bench", {0.62, 0.44, 0.27}},
      {"box", {0.70, 0.62, 0.50}},
      {"door", {0.55, 0.43, 0.33}},
      {"trash_can", {0.36, 0.42, 0.46}},
      {"tree", {0.45, 0.36, 0.28}},
  }};
  // A bench's seat is of wood, its feet are not.
  if (solid.label == "bench" && std::holds_alternative<Cylinder>(solid.shape)) return kConcrete;
  for (const auto& [label, color] : kByLabel) {
    if (solid.label == label) return color;
  }
  return kGrey;
}

WalkerColors walker_colors(int walker) {
  static const std::array<WalkerColors, 5> kOutfits{{
      {{0.18, 0.42, 0.52}, {0.24, 0.27, 0.36}},
      {{0.84, 0.66, 0.27}, {0.34, 0.30, 0.27}},
      {{0.55, 0.60, 0.66}, {0.20, 0.24, 0.30}},
      {{0.72, 0.48, 0.34}, {0.38, 0.40, 0.42}},
      {{0.33, 0.36, 0.56}, {0.46, 0.42, 0.36}},
  }};
  return kOutfits[static_cast<std::size_t>(walker) % kOutfits.size()];
}

}  // namespace scanbed::sim
