// SPDX-License-Identifier: MIT
#include "bench/train_legs/leg_worlds.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/geometry/angles.hpp"
#include "core/geometry/polar.hpp"
#include "core/geometry/pose2.hpp"
#include "sim/generate/hall_outline.hpp"
#include "sim/generate/world_dice.hpp"
#include "sim/sensor/sensor_presets.hpp"
#include "sim/world/solid_geometry.hpp"

namespace scanbed::bench {
namespace {

using Eigen::Vector2d;
using sim::World;

constexpr int kTrials = 40;
constexpr double kRobotRoom_m = 0.28;

// The robot stands at the origin and looks along x.
class LegWorldBuilder {
 public:
  explicit LegWorldBuilder(std::uint64_t seed) : dice_(seed, "leg_world") {}

  World build() {
    // Rooms seldom hold all kinds of things at once.
    put_walls();
    const double density = dice_.uniform(0.0, 1.5);
    repeat(3.0 * density, [&] { put_box(0.15, 1.2, 3.0); });
    repeat(2.0 * density, [&] { put_box(0.05, 0.25, 2.0); });
    repeat(1.5 * density, [&] { put_stub(); });
    repeat(1.0 * density, [&] { put_nook(); });
    repeat(1.0 * density, [&] { put_column(); });
    repeat(0.8 * density, [&] { put_blob(); });
    repeat(1.5 * density, [&] { put_legged_thing(); });
    repeat(1.5 * density, [&] { put_thin_post(); });
    repeat(0.3 * density, [&] { put_leglike_post(); });
    for (int i = dice_.whole(0, 4); i > 0; --i) put_person();
    return std::move(world_);
  }

 private:
  template <typename Put>
  void repeat(double mean, const Put& put) {
    const int count = static_cast<int>(std::floor(2.0 * mean * dice_.uniform(0.0, 1.0) + 0.5));
    for (int i = 0; i < count; ++i) put();
  }

  void add(const char* label, sim::SolidShape shape) {
    world_.solids.push_back(
        {.id = label + std::to_string(world_.solids.size()), .label = label, .shape = std::move(shape)});
    sim::Material& material = world_.solids.back().material;
    material.reflectivity = dice_.uniform(0.15, 0.9);
  }

  double clearance_m(const Vector2d& p_m) const {
    double least_m = p_m.norm() - kRobotRoom_m;
    for (const sim::Solid& solid : world_.solids) {
      least_m = std::min(least_m, sim::clearance_m(solid.shape, p_m));
    }
    return least_m;
  }

  bool is_inside(const Vector2d& p_m) const {
    return p_m.x() > low_m_.x() && p_m.x() < high_m_.x() && p_m.y() > low_m_.y() && p_m.y() < high_m_.y();
  }

  // A place in view of the laser, or nearly so, with so much room and no more than `most_m` if given.
  bool place(double room_m, Vector2d& p_m, double most_m = 1e9) {
    for (int trial = 0; trial < kTrials; ++trial) {
      // Half of it even in area, half in range: near things fill more of the view.
      const double share = dice_.uniform(0.0, 1.0);
      p_m = polar(dice_.uniform(-1.75, 1.75), 0.3 + 6.7 * (dice_.chance(0.5) ? share : std::sqrt(share)));
      const double free_m = clearance_m(p_m);
      if (is_inside(p_m) && free_m >= room_m && free_m <= most_m) return true;
    }
    return false;
  }

  double turn() { return dice_.uniform(-kPi, kPi); }

  void put_walls() {
    low_m_ = Vector2d::Constant(-9.0);
    high_m_ = Vector2d::Constant(9.0);
    if (dice_.chance(0.25)) return;  // an open floor
    const bool corridor = dice_.chance(0.3);
    const double turn_rad = turn();
    const double half_x_m = dice_.uniform(1.5, 8.0);
    const double half_y_m = corridor ? dice_.uniform(0.7, 1.5) : dice_.uniform(1.2, 6.0);
    const Vector2d center_m(dice_.uniform(-0.9, 0.9) * (half_x_m - 0.4),
                            dice_.uniform(-0.9, 0.9) * (half_y_m - 0.4));
    const sim::WallNiches niches{.chance = dice_.uniform(0.0, 0.8),
                                 .first = {0.3, 1.5},
                                 .next = {1.4, 3.0},
                                 .last_m = 1.5,
                                 .width = {0.08, 1.2},
                                 .depth = {-0.15, 0.35}};
    sim::WallChain hall = sim::hall_outline({half_x_m, half_y_m}, niches, dice_);
    const Pose2 turned{Vector2d::Zero(), turn_rad};
    low_m_ = high_m_ = Vector2d::Zero();
    for (Vector2d& c_m : hall.corners_m) {
      c_m = turned * (c_m - center_m);
      low_m_ = low_m_.cwiseMin(c_m);
      high_m_ = high_m_.cwiseMax(c_m);
    }
    add_with_doors(hall);
  }

  // Walls with pieces missing: doors, and passages behind which there is nothing.
  void add_with_doors(const sim::WallChain& hall) {
    const double door_chance = dice_.uniform(0.0, 0.35);
    const std::size_t n = hall.corners_m.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vector2d a_m = hall.corners_m[i];
      const Vector2d b_m = hall.corners_m[(i + 1) % n];
      const double length_m = (b_m - a_m).norm();
      if (length_m > 1.6 && dice_.chance(door_chance)) {
        const double door_m = dice_.uniform(0.7, 1.4);
        const double at_m = dice_.uniform(0.05, length_m - door_m - 0.05);
        const Vector2d along = (b_m - a_m) / length_m;
        add("wall", sim::WallChain{{a_m, a_m + at_m * along}, false});
        add("wall", sim::WallChain{{a_m + (at_m + door_m) * along, b_m}, false});
      } else if (length_m > 1e-3) {
        add("wall", sim::WallChain{{a_m, b_m}, false});
      }
    }
  }

  void put_box(double min_m, double max_m, double max_aspect) {
    const double a_m = dice_.uniform(min_m, max_m);
    const double b_m = a_m * dice_.uniform(1.0, max_aspect);
    Vector2d p_m;
    if (place(std::hypot(a_m, b_m) / 2, p_m)) add("box", sim::Box{{p_m, turn()}, {a_m, b_m}});
  }

  void put_stub() {
    Vector2d p_m;
    const double length_m = dice_.uniform(0.08, 0.6);
    if (place(length_m / 2, p_m)) add("stub", sim::Box{{p_m, turn()}, {length_m, dice_.uniform(0.02, 0.15)}});
  }

  // Two or three short walls in a row: edges, nooks, corners of cupboards.
  void put_nook() {
    Vector2d p_m;
    const double size_m = dice_.uniform(0.1, 0.6);
    if (!place(size_m, p_m)) return;
    double heading_rad = turn();
    std::vector<Vector2d> corners_m{p_m};
    for (int i = dice_.whole(2, 3); i > 0; --i) {
      corners_m.push_back(corners_m.back() + polar(heading_rad, size_m * dice_.uniform(0.4, 1.0) / 2));
      heading_rad += dice_.uniform(0.5, 2.0) * (dice_.chance(0.5) ? 1.0 : -1.0);
    }
    add("corner", sim::WallChain{corners_m, false});
  }

  void put_column() {
    const double radius_m = 0.13 * std::pow(5.0, dice_.uniform(0.0, 1.0));
    Vector2d p_m;
    if (place(radius_m, p_m)) add("column", sim::Cylinder{p_m, radius_m});
  }

  // A convex thing of no name: bags, plants, boxes of other shapes.
  void put_blob() {
    const double size_m = 0.06 * std::pow(6.0, dice_.uniform(0.0, 1.0));
    Vector2d p_m;
    if (!place(size_m, p_m)) return;
    const int sides = dice_.whole(3, 6);
    const double stretch = dice_.uniform(0.4, 1.0);
    add("blob", oval(p_m, {size_m, size_m * stretch}, turn(), sides));
  }

  static sim::Polygon oval(const Vector2d& p_m, const Vector2d& half_m, double turn_rad, int sides) {
    const Pose2 pose{p_m, turn_rad};
    sim::Polygon polygon;
    for (int i = 0; i < sides; ++i) {
      polygon.corners_m.push_back(pose * half_m.cwiseProduct(polar(2.0 * kPi * i / sides, 1.0)));
    }
    return polygon;
  }

  // Chairs, stools, tables: thin legs in a rectangle, sometimes a round foot or wheels in a star.
  void put_legged_thing() {
    Vector2d p_m;
    const bool table = dice_.chance(0.4);
    const double half_x_m = table ? dice_.uniform(0.3, 0.8) : dice_.uniform(0.17, 0.27);
    const double half_y_m = table ? dice_.uniform(0.25, 0.5) : dice_.uniform(0.17, 0.27);
    if (!place(table ? 0.3 : std::hypot(half_x_m, half_y_m), p_m)) return;
    const double leg_m = table ? dice_.uniform(0.012, 0.035) : dice_.uniform(0.008, 0.022);
    const Pose2 pose{p_m, turn()};
    const bool star = !table && dice_.chance(0.3);
    if (star) {
      put_star(pose, half_x_m, leg_m);
    } else {
      for (const double y_m : {half_y_m, -half_y_m}) {
        for (const double x_m : {half_x_m, -half_x_m}) put_chair_leg(pose, {x_m, y_m}, leg_m);
      }
    }
  }

  void put_star(const Pose2& pose, double reach_m, double leg_m) {
    for (int i = 0; i < 5; ++i) put_chair_leg(pose, polar(2.0 * kPi * i / 5, reach_m), leg_m);
    if (clearance_m(pose.p_m) > 0.03) add("furniture", sim::Cylinder{pose.p_m, dice_.uniform(0.015, 0.03)});
  }

  void put_chair_leg(const Pose2& pose, const Vector2d& q_m, double leg_m) {
    const Vector2d at_m = pose * q_m;
    if (clearance_m(at_m) < leg_m) return;
    if (dice_.chance(0.5)) {
      add("furniture", sim::Cylinder{at_m, leg_m});
    } else {
      add("furniture", sim::Box{{at_m, pose.theta_rad}, Vector2d::Constant(2.0 * leg_m)});
    }
  }

  void put_thin_post() {
    Vector2d p_m;
    const double radius_m = dice_.uniform(0.008, 0.03);
    if (place(radius_m, p_m)) add("thin", sim::Cylinder{p_m, radius_m});
  }

  void put_leglike_post() {
    Vector2d p_m;
    const double radius_m = dice_.uniform(0.035, 0.13);
    if (place(radius_m, p_m)) add("post", sim::Cylinder{p_m, radius_m});
  }

  void put_person() {
    const double radius_m = 0.035 * std::pow(0.105 / 0.035, dice_.uniform(0.0, 1.0));
    const bool touching = dice_.chance(0.25);
    const double apart_m = touching ? 2.0 * radius_m + dice_.uniform(0.0, 0.03)
                                    : 2.0 * radius_m + 0.02 + 0.45 * std::pow(dice_.uniform(0.0, 1.0), 1.5);
    // In the open, or beside something.
    const bool beside = dice_.chance(0.2);
    const double room_m = radius_m + (beside ? 0.04 : dice_.uniform(0.15, 0.8));
    for (int trial = 0; trial < kTrials; ++trial) {
      Vector2d p_m;
      if (!place(room_m, p_m, beside ? room_m + 0.35 : 1e9)) return;
      const Vector2d q_m = p_m + polar(turn(), apart_m);
      if (clearance_m(q_m) < room_m || !is_inside(q_m)) continue;
      add_leg(p_m, radius_m);
      add_leg(q_m, radius_m * dice_.uniform(0.9, 1.1));
      return;
    }
  }

  // Round, oval, or flat as the front of trousers often is.
  void add_leg(const Vector2d& p_m, double radius_m) {
    if (dice_.chance(0.2)) {
      add("leg", sim::Cylinder{p_m, radius_m});
    } else {
      const Vector2d half_m(radius_m * dice_.uniform(1.0, 1.3), radius_m * dice_.uniform(0.15, 1.0));
      // Mostly its broad side is seen, be it from front or back.
      const double across_rad = std::atan2(p_m.x(), -p_m.y());
      const double turn_rad = dice_.chance(0.5) ? across_rad + dice_.uniform(-0.6, 0.6) : turn();
      add("leg", oval(p_m, half_m, turn_rad, 16));
    }
    world_.solids.back().material.roughness_m = dice_.chance(0.3) ? dice_.uniform(0.0, 0.008) : 0.0;
  }

  sim::WorldDice dice_;
  World world_;
  Vector2d low_m_ = Vector2d::Zero();
  Vector2d high_m_ = Vector2d::Zero();
};

}  // namespace

sim::World leg_world(std::uint64_t seed) {
  return LegWorldBuilder(seed).build();
}

sim::SensorOptions leg_sensor(std::uint64_t seed) {
  sim::WorldDice dice(seed, "leg_sensor");
  sim::SensorOptions sensor = sim::sensor_preset("sick_lms200");
  sensor.interlace = false;
  if (dice.chance(0.5)) {  // a wider spot
    sensor.spot.diameter_m = 0.010;
    sensor.spot.divergence_rad = dice.uniform(0.004, 0.010);
  }
  const double kSteps_deg[] = {0.25, 1.0 / 3.0, 0.352, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 1.0};
  sensor.step_rad = radians(kSteps_deg[dice.whole(0, 9)]);
  sensor.fov_rad = sensor.step_rad * std::floor(radians(180.0) / sensor.step_rad + 1e-6);
  sensor.noise_sigma_m = 0.002 * std::pow(12.0, dice.uniform(0.0, 1.0));
  sensor.effects.bias = 0.0;
  const double kReach_m[] = {5.6, 8.0, 11.0, 30.0};
  sensor.max_range_m = kReach_m[dice.whole(0, 3)];
  sensor.word_bits = 15;
  return sensor;
}

}  // namespace scanbed::bench
