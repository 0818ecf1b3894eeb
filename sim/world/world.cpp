// SPDX-License-Identifier: MIT
#include "sim/world/world.hpp"

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "core/errors/input_error.hpp"
#include "core/geometry/cross.hpp"
#include "core/text/number_text.hpp"
#include "sim/world/check_places.hpp"
#include "sim/world/drive_plan.hpp"
#include "sim/world/gait.hpp"
#include "sim/world/quoted.hpp"
#include "sim/world/rounded_path.hpp"
#include "sim/world/solid_geometry.hpp"
#include "sim/world/world_limits.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kMostWalked_m = 1e6;

void require_positive(double value, const std::string& name) {
  require(std::isfinite(value) && value > 0.0 && value <= kFarthest_m, name, value, "> 0, at most 1000");
}

void require_not_negative(double value, const std::string& name) {
  require(std::isfinite(value) && value >= 0.0, name, value, "finite, >= 0");
}

void require_place(const Vector2d& p, const std::string& name) {
  for (const double value : {p.x(), p.y()}) {
    require(std::abs(value) <= kFarthest_m, name, value, "within 1000 m of the origin");
  }
}

void require_pose(const Pose2& pose, const std::string& name) {
  require_place(pose.p_m, name + ": position");
  require(std::isfinite(pose.theta_rad), name + ": angle_rad", pose.theta_rad, "finite");
}

void check_corners(const std::vector<Vector2d>& corners_m, bool closed, const std::string& name) {
  const std::size_t least = closed ? 3 : 2;
  require(corners_m.size() >= least, name + ": number of corners", static_cast<double>(corners_m.size()),
          ">= " + std::to_string(least));
  for (const Vector2d& corner : corners_m) require_place(corner, name + ": corner");
  for (std::size_t i = closed ? 0 : 1; i < corners_m.size(); ++i) {
    const double length_m = (corners_m[i] - corners_m[i == 0 ? corners_m.size() - 1 : i - 1]).norm();
    require(length_m >= kMinEdge_m, name + ": length of the edge that ends at corner " + std::to_string(i),
            length_m, ">= 0.001 m");
  }
}

// Every turn to the left, once round in all: a star turns left too, but twice round.
void check_convex(const std::vector<Vector2d>& corners_m, const std::string& name) {
  const std::size_t n = corners_m.size();
  double sum_rad = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d before = corners_m[i] - corners_m[(i + n - 1) % n];
    const Vector2d behind = corners_m[(i + 1) % n] - corners_m[i];
    const double turn_rad = std::atan2(cross(before, behind), before.dot(behind));
    require(turn_rad > 0.0 && turn_rad < kPi, name + ": turn_rad at corner " + std::to_string(i), turn_rad,
            "> 0, < pi (convex, counter-clockwise)");
    sum_rad += turn_rad;
  }
  require(sum_rad < 3.0 * kPi, name + ": turns of the outline", sum_rad / (2.0 * kPi), "once round");
}

struct CheckShape {
  const std::string& name;

  void operator()(const WallChain& chain) const { check_corners(chain.corners_m, chain.closed, name); }
  void operator()(const Cylinder& cylinder) const {
    require_place(cylinder.center_m, name + ": center");
    require_positive(cylinder.radius_m, name + ": radius_m");
  }
  void operator()(const Box& box) const {
    require_pose(box.X_WB, name);
    require_positive(box.size_m.x(), name + ": size_m along x");
    require_positive(box.size_m.y(), name + ": size_m along y");
  }
  void operator()(const Polygon& polygon) const {
    check_corners(polygon.corners_m, true, name);
    check_convex(polygon.corners_m, name);
  }
};

void check_material(const Material& material, const std::string& name) {
  require(material.reflectivity > 0.0 && material.reflectivity <= 1.0, name + ": reflectivity",
          material.reflectivity, "(0, 1]");
  require(material.roughness_m >= 0.0 && material.roughness_m <= 1.0, name + ": roughness_m",
          material.roughness_m, "[0, 1]");
}

void check_solid(const Solid& solid) {
  const std::string name = quoted("solid", solid.id);
  std::visit(CheckShape{name}, solid.shape);
  require(std::isfinite(solid.bottom_m), name + ": bottom_m", solid.bottom_m, "finite");
  require(std::isfinite(solid.top_m) && solid.top_m > solid.bottom_m, name + ": top_m", solid.top_m,
          "finite, > bottom_m");
  check_material(solid.material, name);
}

void check_tow(const Tow& tow) {
  const std::string name = quoted("towed cylinder", tow.id);
  require_positive(tow.radius_m, name + ": radius_m");
  require_positive(tow.height_m, name + ": height_m");
  require_positive(tow.rope_m, name + ": rope_m");
  require_positive(tow.mass_kg, name + ": mass_kg");
  require_not_negative(tow.friction, name + ": friction");
  check_material(tow.material, name);
}

void check_stops(const Walker& walker, const std::string& name) {
  if (walker.stops.empty()) return;
  // Behind the end of an open path nobody walks, so nobody would stop.
  const double end_m = walker.path.loop ? kMostWalked_m : RoundedPath(walker.path).length_m();
  double before_m = -1.0;
  for (std::size_t i = 0; i < walker.stops.size(); ++i) {
    const Stop& stop = walker.stops[i];
    const std::string which = name + ": stop " + std::to_string(i);
    require(stop.at_m >= 0.0 && stop.at_m > before_m, which + ": at_m", stop.at_m,
            ">= 0, behind the stop before");
    require(stop.at_m <= end_m, which + ": at_m", stop.at_m,
            "at most " + number_text(end_m) + " m, where its path ends");
    require(std::abs(stop.turn_rad) <= 2.0 * kPi, which + ": turn_rad", stop.turn_rad, "at most one turn");
    const double least_s = shortest_stop_s(walker.speed_m_per_s, stop.turn_rad);
    require(stop.for_s >= least_s, which + ": for_s", stop.for_s,
            ">= " + number_text(least_s) + ", to set the feet down and turn");
    before_m = stop.at_m;
  }
}

void check_walker(const Walker& walker) {
  const std::string name = quoted("walker", walker.id);
  validate_path(walker.path, name);
  for (const Vector2d& p : walker.path.points_m) require_place(p, name + ": path");
  require_positive(walker.speed_m_per_s, name + ": speed_m_per_s");
  require_not_negative(walker.start_s, name + ": start_s");
  require_positive(walker.leg_radius_m, name + ": leg_radius_m");
  require_positive(walker.leg_length_m, name + ": leg_length_m");
  require_not_negative(walker.step_width_m, name + ": step_width_m");
  require_positive(walker.height_m, name + ": height_m");
  check_material(walker.material, name);
  require(std::abs(walker.lateral_m) <= 10.0, name + ": lateral_m", walker.lateral_m, "[-10, 10]");
  check_stops(walker, name);
  if (walker.tow) check_tow(*walker.tow);
}

void check_robot(const Robot& robot) {
  require_pose(robot.X_WR, "robot");
  require_pose(robot.X_RS, "robot: laser");
  require_positive(robot.laser_height_m, "robot: laser_height_m");
  for (const auto& [tilt_rad, name] :
       {std::pair(robot.laser_pitch_rad, "pitch"), std::pair(robot.laser_roll_rad, "roll")}) {
    require(std::abs(tilt_rad) <= radians(80.0), std::string("robot: laser_") + name + "_rad", tilt_rad,
            "[-1.396, 1.396], 80 degrees");
  }
  require_positive(robot.speed_m_per_s, "robot: speed_m_per_s");
  require_positive(robot.turn_rad_per_s, "robot: turn_rad_per_s");
  require_positive(robot.radius_m, "robot: radius_m");
  validate_drive(robot);
}

// Ids as truth will name them in either engine, so that "hall.1" cannot be both a wall of hall and a column.
class Ids {
 public:
  void add(const std::string& id, const std::string& whose) {
    if (id.empty()) throw InputError(whose + ": id: is empty; allowed: a name of its own");
    if (!seen_.insert(id).second) {
      throw InputError(whose + ": id: '" + id + "' is taken; allowed: a name of its own");
    }
  }

 private:
  std::set<std::string> seen_;
};

void check_ids(const World& world) {
  Ids ids;
  ids.add("floor", "the floor");
  for (const Solid& solid : world.solids) {
    ids.add(solid.id, quoted("solid", solid.id));
    ids.add(solid.id + ".top", quoted("solid", solid.id));
    const std::size_t num_edges = outline(solid.shape).size();
    for (std::size_t i = 0; i < num_edges; ++i) {
      ids.add(solid.id + "." + std::to_string(i), quoted("solid", solid.id));
    }
  }
  for (const Walker& walker : world.walkers) {
    for (const char* part : {"", ".left_leg", ".right_leg", ".body"}) {
      ids.add(walker.id.empty() ? "" : walker.id + part, quoted("walker", walker.id));
    }
    if (!walker.tow) continue;
    ids.add(walker.tow->id, quoted("towed cylinder", walker.tow->id));
    ids.add(walker.tow->id + ".top", quoted("towed cylinder", walker.tow->id));
  }
}

}  // namespace

void World::validate() const {
  for (const Solid& solid : solids) check_solid(solid);
  for (const Walker& walker : walkers) check_walker(walker);
  check_robot(robot);
  check_ids(*this);
  check_places(*this);
}

}  // namespace scanbed::sim
