// SPDX-License-Identifier: MIT
#include "sim/spatial/world_bounds.hpp"

#include <algorithm>
#include <variant>

namespace scanbed::sim {
namespace {

struct Outline {
  Eigen::AlignedBox2d& box;

  void operator()(const WallChain& chain) const {
    for (const Eigen::Vector2d& p_WQ : chain.corners_m) box.extend(p_WQ);
  }
  void operator()(const Cylinder& cylinder) const {
    const Eigen::Vector2d reach = Eigen::Vector2d::Constant(cylinder.radius_m);
    box.extend(Eigen::Vector2d(cylinder.center_m - reach));
    box.extend(Eigen::Vector2d(cylinder.center_m + reach));
  }
  void operator()(const Box& solid) const {
    for (const double sx : {-0.5, 0.5}) {
      for (const double sy : {-0.5, 0.5})
        box.extend(solid.X_WB * Eigen::Vector2d(sx * solid.size_m.x(), sy * solid.size_m.y()));
    }
  }
  void operator()(const Polygon& polygon) const {
    for (const Eigen::Vector2d& p_WQ : polygon.corners_m) box.extend(p_WQ);
  }
};

void extend_by_disc(Eigen::AlignedBox2d& box, const Eigen::Vector2d& center_m, double radius_m) {
  box.extend(Eigen::Vector2d(center_m.array() - radius_m));
  box.extend(Eigen::Vector2d(center_m.array() + radius_m));
}

}  // namespace

Eigen::AlignedBox3d world_bounds(const World& world) {
  constexpr double kElbow_m = 0.3;  // half the width of a person
  Eigen::AlignedBox2d plan;
  double top_m = 1.0;
  for (const Solid& solid : world.solids) {
    std::visit(Outline{plan}, solid.shape);
    top_m = std::max(top_m, solid.top_m);
  }
  for (const Walker& walker : world.walkers) {
    for (const Eigen::Vector2d& p_WQ : walker.path.points_m) extend_by_disc(plan, p_WQ, kElbow_m);
    top_m = std::max(top_m, walker.height_m);
  }
  extend_by_disc(plan, world.robot.X_WR.p_m, world.robot.radius_m);

  const Eigen::Vector2d half_m = (0.5 * plan.sizes()).cwiseMax(1.0);
  const Eigen::Vector2d center_m = plan.center();
  Eigen::AlignedBox3d bounds;
  bounds.extend(Eigen::Vector3d(center_m.x() - half_m.x(), center_m.y() - half_m.y(), 0.0));
  bounds.extend(Eigen::Vector3d(center_m.x() + half_m.x(), center_m.y() + half_m.y(), top_m));
  return bounds;
}

}  // namespace scanbed::sim
