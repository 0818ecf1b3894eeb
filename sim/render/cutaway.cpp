// SPDX-License-Identifier: MIT
#include "sim/render/cutaway.hpp"

#include <algorithm>
#include <string>

#include "core/errors/ensure.hpp"
#include "core/geometry/cross.hpp"
#include "sim/spatial/part_names.hpp"

namespace scanbed::sim {
namespace {

constexpr double kKerb_m = 0.10;

// Positive where Q is to the left of the way from A to B.
double side_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& q) {
  return cross(b - a, q - a);
}

void lower(const std::string& wall, mjModel& model) {
  const int geom = mj_name2id(&model, mjOBJ_GEOM, wall.c_str());
  SCANBED_ENSURE(geom >= 0 && model.geom_type[geom] == mjGEOM_BOX);
  mjtNum& half_height_m = model.geom_size[3 * geom + 2];
  mjtNum& middle_m = model.geom_pos[3 * geom + 2];
  const double bottom_m = middle_m - half_height_m;
  half_height_m = std::min(half_height_m, 0.5 * kKerb_m);
  middle_m = bottom_m + half_height_m;
}

}  // namespace

void cut_away_walls(const World& world, const Eigen::Vector2d& camera_m, const Eigen::Vector2d& middle_m,
                    mjModel& model) {
  for (const Solid& solid : world.solids) {
    const auto* chain = std::get_if<WallChain>(&solid.shape);
    if (chain == nullptr) continue;
    const int num_corners = static_cast<int>(chain->corners_m.size());
    const int num_walls = chain->closed ? num_corners : num_corners - 1;
    for (int n = 0; n < num_walls; ++n) {
      const Eigen::Vector2d& from_m = chain->corners_m[n];
      const Eigen::Vector2d& to_m = chain->corners_m[(n + 1) % num_corners];
      const double product = side_of(from_m, to_m, camera_m) * side_of(from_m, to_m, middle_m);
      if (product < 0.0) lower(solid_name(solid.id, n), model);
    }
  }
}

}  // namespace scanbed::sim
