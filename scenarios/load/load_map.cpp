// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <filesystem>

#include "core/errors/input_error.hpp"
#include "scenarios/load/confined_path.hpp"
#include "scenarios/load/sections.hpp"
#include "scenarios/load/table.hpp"
#include "scenarios/load/yaml.hpp"
#include "sim/map/grey_image.hpp"
#include "sim/map/trace_outlines.hpp"

namespace scanbed::scenarios {
namespace {

constexpr Allowed kResolution_m{.least = 0.005, .greatest = 10.0};
constexpr Allowed kThreshold{.least = 0.0, .greatest = 1.0};
// A scan's time grows with each of them, and no laser sees more.
constexpr std::size_t kMostWalls = 10'000;

/// A map as map_server describes it.
struct MapDescription {
  std::filesystem::path image;
  Place image_place;
  double resolution_m = 0.05;
  Pose2 X_WM;  ///< of the image's lowest left corner, radians
  double occupied_ratio = 0.65;
  bool is_negated = false;  ///< white is occupied
};

std::filesystem::path find_beside(const Value& name) {
  const std::shared_ptr<const Source>& source = name.node().place.source;
  return find_confined(name.node().place, name.text(), source ? source->folder : std::filesystem::path());
}

// 0 and 1 as well as false and true: maps are written either way.
bool load_negate(const Value& value) {
  const std::string& text = value.node().text;
  if (!value.node().is_quoted && (text == "0" || text == "1")) return text == "1";
  return value.flag();
}

Pose2 load_origin(const Value& value) {
  // Unlike poses of scenarios: map_server's yaw is in radians.
  const std::vector<Value> xyz = value.items(3);
  return {{xyz[0].number(kCoordinate), xyz[1].number(kCoordinate)},
          xyz[2].number({.least = -1e3, .greatest = 1e3})};
}

MapDescription load_description(const TreeNode& root) {
  static const std::array<std::string, 2> kModes = {"trinary", "scale"};
  const Variables none;
  Table table(Value(root, "map", none));
  MapDescription map;
  const Value image = table.need("image");
  map.image = find_beside(image);
  map.image_place = image.node().place;
  map.resolution_m = table.need("resolution").number(kResolution_m);
  map.X_WM = load_origin(table.need("origin"));
  map.occupied_ratio = table.need("occupied_thresh").number(kThreshold);
  // Between the thresholds a cell is unknown; like a free one, it is no wall.
  const Value free = table.need("free_thresh");
  if (free.number(kThreshold) > map.occupied_ratio) free.refuse("is greater than occupied_thresh");
  map.is_negated = load_negate(table.need("negate"));
  // Both have the same occupied cells.
  if (const auto mode = table.take("mode")) mode->choice(kModes);
  table.finish();
  return map;
}

sim::OccupiedCells occupied_cells(const sim::GreyImage& image, const MapDescription& map) {
  sim::OccupiedCells grid{image.width_px, image.height_px, std::vector<bool>(image.shades.size())};
  std::array<bool, 256> is_occupied{};
  for (int shade = 0; shade < 256; ++shade) {
    const double ratio = (map.is_negated ? shade : 255 - shade) / 255.0;
    is_occupied[static_cast<std::size_t>(shade)] = ratio > map.occupied_ratio;
  }
  for (int row = 0; row < image.height_px; ++row) {
    const std::size_t from = image.index(0, image.height_px - 1 - row);
    const std::size_t to = image.index(0, row);
    for (std::size_t column = 0; column < static_cast<std::size_t>(image.width_px); ++column) {
      const bool is_clear = !image.is_clear.empty() && image.is_clear[from + column];
      grid.cells[to + column] = !is_clear && is_occupied[image.shades[from + column]];
    }
  }
  return grid;
}

std::vector<sim::Outline> trace(const MapDescription& map) {
  try {
    return sim::trace_outlines(occupied_cells(sim::read_grey_image(map.image), map), kMostWalls);
  } catch (const InputError& error) {
    refuse(map.image_place, fmt::format("image: {}", error.what()));
  }
}

}  // namespace

void load_map(const Value& value, const sim::Solid& frame, std::vector<sim::Solid>& solids) {
  const MapDescription map = load_description(read_yaml(find_beside(value)));
  const std::vector<sim::Outline> outlines = trace(map);
  if (outlines.empty()) value.refuse("the map has no occupied cell");
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    sim::Solid solid = frame;
    solid.id = fmt::format("{}.{}", frame.id, i);
    sim::WallChain walls{.corners_m = {}, .closed = true, .bounds_matter = true};
    for (const Eigen::Vector2d& corner : outlines[i]) {
      walls.corners_m.emplace_back(map.X_WM * Eigen::Vector2d(map.resolution_m * corner));
    }
    solid.shape = std::move(walls);
    solids.push_back(std::move(solid));
  }
}

}  // namespace scanbed::scenarios
