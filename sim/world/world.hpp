// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/geometry/pose2.hpp"

namespace scanbed::sim {

/// How a surface answers the laser.
struct Material {
  double reflectivity = 0.5;  ///< diffuse, (0, 1]
  bool glass = false;         ///< throws light back only when hit nearly head-on, else off to elsewhere
  double roughness_m = 0.0;   ///< standard deviation of its depth from beam to beam: cloth, bark, leaves
};

/// Thin upright walls along a polyline; each edge is one wall, named "<id>.<n>" from 0 in truth.
struct WallChain {
  std::vector<Eigen::Vector2d> corners_m;  ///< p_WQ, at least 2, no two neighbours equal
  bool closed = false;                     ///< the last corner joins the first
  bool bounds_matter = false;              ///< closed: what lies to their left is filled, as in a map
};

struct Cylinder {
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();  ///< p_WC
  double radius_m = 0.25;
};

struct Box {
  Pose2 X_WB;                                             ///< of its centre
  Eigen::Vector2d size_m = Eigen::Vector2d::Constant(1);  ///< along its x and y axes
};

/// Convex outline, counter-clockwise.
struct Polygon {
  std::vector<Eigen::Vector2d> corners_m;  ///< p_WQ, at least 3
};

using SolidShape = std::variant<WallChain, Cylinder, Box, Polygon>;

/// A thing that stands still. A laser at height h meets it if bottom_m <= h <= top_m.
struct Solid {
  std::string id;
  std::string label;  ///< what it is: "wall", "column", "bench", "box", ...
  SolidShape shape;
  double bottom_m = 0.0;
  double top_m = 2.5;
  Material material;
};

/// A polyline that a walker follows at its speed.
struct Path {
  std::vector<Eigen::Vector2d> points_m;  ///< p_WQ, at least 2
  bool loop = false;                      ///< back to the first point and round again; else stand at the end
  double round_m = 0.0;                   ///< radius at which corners are rounded; 0 turns on the spot
  bool leave = false;                     ///< at the end of an open path the walker vanishes
};

/// A cylinder pulled over the floor on a rope.
struct Tow {
  std::string id;
  std::string label = "mobile_cylinder";
  double radius_m = 0.25;
  double height_m = 1.0;
  double rope_m = 0.9;  ///< from the walker's pelvis to the cylinder's surface, when taut
  double mass_kg = 8.0;
  double friction = 0.3;  ///< Coulomb, between cylinder and floor
  Material material;

  /// From the walker's pelvis to the cylinder's axis when the rope is taut: a pulled cylinder turns its
  /// rope's end towards the puller.
  double taut_m() const { return rope_m + radius_m; }
};

/// A rest on a walker's way: it stands at `at_m` for a while, feet side by side.
struct Stop {
  double at_m = 0.0;   ///< from the start of its path, as it walks
  double for_s = 2.0;  ///< infinity: for good
  double turn_rad =
      0.0;  ///< meanwhile it turns on the spot by this, counter-clockwise, and back before it goes
};

/// A person. Legs are cylinders at the laser's height, in truth "<id>.left_leg" and "<id>.right_leg".
struct Walker {
  std::string id;
  Path path;
  double speed_m_per_s = 1.37;
  double start_s = 0.0;        ///< the walker is not in the world before
  double leg_radius_m = 0.06;  ///< at the laser's height
  double leg_length_m = 0.93;  ///< hip above the floor
  double step_width_m = 0.10;  ///< between the feet, across the direction of walking
  double height_m = 1.75;
  std::optional<Tow> tow;
  Material material;        ///< of the legs, as clothed
  double lateral_m = 0.0;   ///< walks so far to the left of its path: two on one path are a pair
  std::vector<Stop> stops;  ///< in the order of at_m
  bool avoids = false;      ///< steps aside for other walkers
};

// Steps of a robot's drive plan, one after the other; it stands still when they are done.
struct Wait {
  double duration_s = 0.0;
};
struct Turn {
  double angle_rad = 0.0;  ///< counter-clockwise; more than a full turn is possible
};
struct Go {
  double distance_m = 0.0;  ///< ahead; negative goes backwards
};
/// Drives from where it is to the first point, on to the others, and stops at the last; it turns on the spot
/// to face the first one.
struct FollowPath {
  std::vector<Eigen::Vector2d> points_m;  ///< p_WQ, at least 1
  int rounds = 0;  ///< 0: the path ends at its last point; else back to the first one, so many times round
  /// Radius at which corners are rounded where their edges have room, half an edge a corner; tight arcs are
  /// driven as slowly as the robot's turning needs, sharp corners turned on the spot. Empty: the tightest arc
  /// that it takes at full speed.
  std::optional<double> round_m;
};
/// Drives after the nearest pair of legs that the detector finds, at a distance (LegFollower).
struct FollowLegs {
  double distance_m = 1.0;  ///< that it keeps, from the laser to the middle between the legs
  double for_s = std::numeric_limits<double>::infinity();  ///< from then on comes the next step
  double within_m = 4.0;    ///< pairs of legs farther off are nobody to begin to follow
  double patience_s = 1.0;  ///< goes on for so long without seeing a leg, then stops and looks for a pair
};
using DriveStep = std::variant<Wait, Turn, Go, FollowPath, FollowLegs>;

/// The robot that carries the laser.
struct Robot {
  Pose2 X_WR;                    ///< at the start
  Pose2 X_RS;                    ///< laser on the robot, in the plane
  double laser_height_m = 0.28;  ///< above the floor
  double laser_pitch_rad = 0.0;  ///< about the laser's y axis after X_RS; positive looks down
  double laser_roll_rad = 0.0;   ///< about the laser's x axis after the pitch; positive lowers its right side
  double speed_m_per_s = 0.3;    ///< of Go and FollowPath; the greatest of FollowLegs
  double turn_rad_per_s = 0.5;   ///< of Turn; the greatest of FollowPath and FollowLegs
  double radius_m = 0.22;        ///< body: for pictures and collisions
  std::vector<DriveStep> drive;
};

/// All that a scenario puts into the world; every engine is built from it.
struct World {
  std::vector<Solid> solids;
  std::vector<Walker> walkers;
  Robot robot;

  /// @throws InputError naming the first object that cannot be: equal ids, sizes that are not positive and
  /// finite, a
  ///         walker's path or the robot inside a solid, ...
  void validate() const;
};

}  // namespace scanbed::sim
