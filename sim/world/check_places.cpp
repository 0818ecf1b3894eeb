// SPDX-License-Identifier: MIT
#include "sim/world/check_places.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <vector>

#include "core/errors/input_error.hpp"
#include "core/text/number_text.hpp"
#include "sim/world/quoted.hpp"
#include "sim/world/rounded_path.hpp"
#include "sim/world/solid_geometry.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;
using Bounds = Eigen::AlignedBox2d;

constexpr double kRounding_m = 1e-9;

/// Something round that must find room at its start.
struct Disc {
  Vector2d center_m;
  double radius_m;
  double height_m;  ///< what hangs above it is not in its way
};

void check_room(const World& world, const Disc& disc, const std::string& name) {
  for (const Solid& solid : world.solids) {
    if (solid.bottom_m >= disc.height_m || solid.top_m <= 0.0) continue;
    const double room_m = clearance_m(solid.shape, disc.center_m);
    require(room_m >= disc.radius_m, name + ": distance to " + quoted("solid", solid.id), room_m,
            ">= " + number_text(disc.radius_m) + " m, its radius");
  }
}

// How often a polygon runs round a point, counter-clockwise.
int winding_number(const std::vector<Edge>& edges, const Vector2d& p_WQ) {
  int number = 0;
  for (const Edge& edge : edges) {
    const bool rises = edge.a_m.y() <= p_WQ.y();
    if (rises == (edge.b_m.y() <= p_WQ.y())) continue;
    const double t = (p_WQ.y() - edge.a_m.y()) / (edge.b_m.y() - edge.a_m.y());
    if (edge.a_m.x() + t * (edge.b_m.x() - edge.a_m.x()) > p_WQ.x()) number += rises ? 1 : -1;
  }
  return number;
}

// In matter whose outlines, and those of its holes, are walls.
void check_in_matter(const World& world, const Vector2d& p_WQ, const std::string& name) {
  int number = 0;
  const Solid* outer = nullptr;
  for (const Solid& solid : world.solids) {
    const auto* walls = std::get_if<WallChain>(&solid.shape);
    if (walls == nullptr || !walls->bounds_matter) continue;
    const int turns = winding_number(outline(solid.shape), p_WQ);
    if (turns > 0) outer = &solid;
    number += turns;
  }
  if (number <= 0 || outer == nullptr) return;
  throw InputError(name + ": is in what " + quoted("solid", outer->id) + " fills; allowed: in the free");
}

void check_room_of_tow(const World& world, const Tow& tow, const Pose2& X_WP) {
  const std::string name = quoted("towed cylinder", tow.id) + ": start, a rope's length behind its walker";
  const Vector2d p_WC = X_WP * Vector2d(-tow.taut_m(), 0.0);
  check_room(world, {p_WC, tow.radius_m, tow.height_m}, name);
  for (const Solid& solid : world.solids) {
    if (solid.bottom_m >= tow.height_m) continue;
    for (const Edge& edge : outline(solid.shape)) {
      require(!crosses(edge, X_WP.p_m, p_WC),
              name + ": rope through " + quoted("solid", solid.id) + ": length_m", tow.rope_m,
              "shorter than to there");
    }
  }
}

void check_room_of_walker(const World& world, const Walker& walker) {
  const std::string name = quoted("walker", walker.id);
  const double radius_m = walker.leg_radius_m;
  const RoundedPath path(walker.path);
  const Pose2 X_WP = path.pose_at(0.0) * Pose2{{0.0, walker.lateral_m}, 0.0};
  check_room(world, {X_WP.p_m, radius_m, walker.height_m}, name + ": start of its path");
  check_in_matter(world, X_WP.p_m, name + ": start of its path");
  for (std::size_t i = 0; i < walker.path.points_m.size() && walker.path.round_m == 0.0; ++i) {
    for (const Solid& solid : world.solids) {
      if (solid.bottom_m >= walker.height_m || std::holds_alternative<WallChain>(solid.shape)) continue;
      const double room_m = clearance_m(solid.shape, walker.path.points_m[i]);
      require(room_m > 0.0,
              name + ": path point " + std::to_string(i) + ": distance to " + quoted("solid", solid.id),
              room_m, "> 0 m, outside it");
    }
  }
  if (walker.tow) check_room_of_tow(world, *walker.tow, X_WP);
}

bool is_filled(const Solid& solid) {
  return !std::holds_alternative<WallChain>(solid.shape);
}

// Both of what is filled: such shapes are convex, so their corners say all.
bool is_wholly_within(const Solid& inner, const Solid& outer) {
  if (inner.bottom_m < outer.bottom_m || inner.top_m > outer.top_m) return false;
  if (const auto* cylinder = std::get_if<Cylinder>(&inner.shape)) {
    return clearance_m(outer.shape, cylinder->center_m) <= kRounding_m - cylinder->radius_m;
  }
  const std::vector<Edge> edges = outline(inner.shape);
  return std::all_of(edges.begin(), edges.end(), [&](const Edge& edge) {
    return clearance_m(outer.shape, edge.a_m) <= kRounding_m &&
           clearance_m(outer.shape, edge.b_m) <= kRounding_m;
  });
}

void check_hidden(const World& world, const std::vector<Bounds>& bounds) {
  for (std::size_t i = 0; i < world.solids.size(); ++i) {
    if (!is_filled(world.solids[i])) continue;
    Bounds reach = bounds[i];
    reach.extend(reach.min() - Vector2d::Constant(kRounding_m));
    reach.extend(reach.max() + Vector2d::Constant(kRounding_m));
    for (std::size_t j = 0; j < world.solids.size(); ++j) {
      if (i == j || !reach.contains(bounds[j])) continue;
      if (!is_wholly_within(world.solids[j], world.solids[i])) continue;
      throw InputError(quoted("solid", world.solids[j].id) + ": lies wholly within " +
                       quoted("solid", world.solids[i].id) + "; allowed: at least partly outside");
    }
  }
}

// Closed walls that go round everything but the robot are where the scenario is: the robot stands outside by
// mistake. Walls alone are no such place; they may be meant to be seen from outside.
void check_enclosed(const World& world, const std::vector<Bounds>& bounds) {
  std::vector<Vector2d> others;
  for (const Walker& walker : world.walkers) {
    others.insert(others.end(), walker.path.points_m.begin(), walker.path.points_m.end());
  }
  for (const Bounds& b : bounds) others.push_back(b.center());
  if (others.size() < 2) return;
  for (std::size_t i = 0; i < world.solids.size(); ++i) {
    const auto* walls = std::get_if<WallChain>(&world.solids[i].shape);
    if (walls == nullptr || !walls->closed) continue;
    const bool is_around =
        std::all_of(bounds.begin(), bounds.end(), [&](const Bounds& b) { return bounds[i].contains(b); });
    if (!is_around) continue;
    const std::vector<Edge> edges = outline(world.solids[i].shape);
    const auto is_in = [&](const Vector2d& p_WQ) { return winding_number(edges, p_WQ) != 0; };
    if (is_in(world.robot.X_WR.p_m) || !std::all_of(others.begin(), others.end(), is_in)) continue;
    throw InputError("robot: start: is outside " + quoted("solid", world.solids[i].id) +
                     ", which encloses everything else; allowed: inside");
  }
}

}  // namespace

void check_places(const World& world) {
  std::vector<Bounds> bounds;
  for (const Solid& solid : world.solids) bounds.push_back(ShapeOutline(solid.shape).bounds());
  check_hidden(world, bounds);
  check_room(world, {world.robot.X_WR.p_m, world.robot.radius_m, world.robot.laser_height_m}, "robot: start");
  check_in_matter(world, world.robot.X_WR.p_m, "robot: start");
  check_enclosed(world, bounds);
  for (const Walker& walker : world.walkers) check_room_of_walker(world, walker);
}

}  // namespace scanbed::sim
