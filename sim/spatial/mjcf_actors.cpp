// SPDX-License-Identifier: MIT
#include "sim/spatial/mjcf_actors.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "sim/spatial/appearance.hpp"
#include "sim/spatial/laser_mount.hpp"
#include "sim/spatial/mjcf_element.hpp"
#include "sim/spatial/part_names.hpp"
#include "sim/spatial/walker_body.hpp"

namespace scanbed::sim {
namespace {

pugi::xml_node add_mocap_body(pugi::xml_node worldbody, const std::string& name) {
  return MjcfElement(worldbody, "body").set("name", name).set("mocap", "true").node();
}

// For what goes anywhere and never turns: by x, y and z.
void add_slides(pugi::xml_node body) {
  MjcfElement(body, "joint").set("type", "slide").set("axis", {1.0, 0.0, 0.0});
  MjcfElement(body, "joint").set("type", "slide").set("axis", {0.0, 1.0, 0.0});
  MjcfElement(body, "joint").set("type", "slide").set("axis", {0.0, 0.0, 1.0});
}

struct Capsule {
  Eigen::Vector3d from_m;
  Eigen::Vector3d to_m;
  double radius_m;
};

void add_capsule(pugi::xml_node body, const Capsule& capsule, const Rgb& color,
                 const GeomRole& role = kSeenOnly) {
  MjcfElement(body, "geom")
      .set("type", "capsule")
      .set_role(role)
      .set("fromto", {capsule.from_m.x(), capsule.from_m.y(), capsule.from_m.z(), capsule.to_m.x(),
                      capsule.to_m.y(), capsule.to_m.z()})
      .set("size", {capsule.radius_m})
      .set_color(color);
}

void add_ellipsoid(pugi::xml_node body, const Eigen::Vector3d& p_BC, const Eigen::Vector3d& half_m,
                   const Rgb& color) {
  MjcfElement(body, "geom")
      .set("type", "ellipsoid")
      .set_role(kSeenOnly)
      .set("pos", {p_BC.x(), p_BC.y(), p_BC.z()})
      .set("size", {half_m.x(), half_m.y(), half_m.z()})
      .set_color(color);
}

void add_torso(const Walker& walker, const WalkerColors& colors, pugi::xml_node torso) {
  const WalkerBody body(walker);
  const double h_m = walker.height_m;
  const double shoulder_y_m = 0.105 * h_m;
  add_ellipsoid(torso, {0.0, 0.0, body.hip_m}, {0.065 * h_m, 0.098 * h_m, 0.06 * h_m}, colors.trousers);
  add_ellipsoid(torso, {0.0, 0.0, 0.5 * (body.hip_m + body.shoulder_m)},
                {0.068 * h_m, 0.1 * h_m, 0.55 * (body.shoulder_m - body.hip_m)}, colors.shirt);
  add_capsule(torso,
              {{0.0, -shoulder_y_m, body.shoulder_m}, {0.0, shoulder_y_m, body.shoulder_m}, 0.036 * h_m},
              colors.shirt);
  add_capsule(torso, {{0.0, 0.0, body.shoulder_m}, {0.01, 0.0, body.head_m}, 0.03 * h_m}, kSkinColor);
  add_ellipsoid(torso, {0.012 * h_m, 0.0, body.head_m}, {0.055 * h_m, 0.045 * h_m, 0.068 * h_m}, kSkinColor);
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d shoulder_m(0.0, side * 1.15 * shoulder_y_m, body.shoulder_m - 0.01);
    const Eigen::Vector3d elbow_m(-0.01 * h_m, side * 1.25 * shoulder_y_m, 0.64 * h_m);
    const Eigen::Vector3d hand_m(0.03 * h_m, side * 1.25 * shoulder_y_m, 0.49 * h_m);
    add_capsule(torso, {shoulder_m, elbow_m, 0.027 * h_m}, colors.shirt);
    add_capsule(torso, {elbow_m, hand_m, 0.022 * h_m}, kSkinColor);
  }
}

void add_leg(const Walker& walker, const std::string& side, const Rgb& trousers, pugi::xml_node worldbody) {
  const WalkerBody body(walker);
  const double r_m = walker.leg_radius_m;
  add_ellipsoid(add_mocap_body(worldbody, walker_name(walker.id, side + "_foot")), {0.05, 0.0, 0.04},
                {0.13, 0.045, 0.045}, kShoeColor);
  add_capsule(add_mocap_body(worldbody, walker_name(walker.id, side + "_shank")),
              {{0.0, 0.0, std::min(0.08, 0.5 * body.shank_m)}, {0.0, 0.0, body.shank_m}, r_m}, trousers,
              kSeenScripted);
  add_capsule(add_mocap_body(worldbody, walker_name(walker.id, side + "_thigh")),
              {{0.0, 0.0, 0.0}, {0.0, 0.0, body.thigh_m}, 1.15 * r_m}, trousers);
}

}  // namespace

void add_robot(const Robot& robot, pugi::xml_node worldbody) {
  constexpr double kCubeHalf_m = 0.085;  // an LMS 200 is some 0.16 m wide and deep, 0.19 m high
  const pugi::xml_node body = add_mocap_body(worldbody, kRobotBody);
  const double deck_m = std::max(0.05, robot.laser_height_m - kCubeHalf_m);
  const double floor_gap_m = 0.03;
  MjcfElement(body, "geom")
      .set("type", "cylinder")
      .set_role(kPictureScripted)
      .set("pos", {0.0, 0.0, 0.5 * (floor_gap_m + deck_m)})
      .set("size", {robot.radius_m, 0.5 * (deck_m - floor_gap_m)})
      .set_color(kRobotColor);
  for (const double side : {-1.0, 1.0}) {
    MjcfElement(body, "geom")
        .set("type", "cylinder")
        .set_role(kPictureOnly)
        .set("pos", {0.0, side * 0.95 * robot.radius_m, 0.08})
        .set("euler", {0.5 * kPi, 0.0, 0.0})
        .set("size", {0.08, 0.02})
        .set_color(0.5 * kShoeColor);
  }
  const Eigen::Quaterniond turn(laser_turn(robot));
  const pugi::xml_node laser = MjcfElement(body, "body")
                                   .set("name", "laser")
                                   .set("pos", {robot.X_RS.p_m.x(), robot.X_RS.p_m.y(), robot.laser_height_m})
                                   .set("quat", {turn.w(), turn.x(), turn.y(), turn.z()})
                                   .node();
  MjcfElement(laser, "geom")
      .set("type", "box")
      .set_role(kPictureOnly)
      .set("size", {kCubeHalf_m, kCubeHalf_m, kCubeHalf_m})
      .set_color(kLaserColor);
  MjcfElement(laser, "geom")
      .set("type", "cylinder")
      .set_role(kPictureOnly)
      .set("pos", {0.03, 0.0, 0.0})
      .set("size", {0.07, 0.025})
      .set_color(kRobotColor);
}

void add_walker(const Walker& walker, int index, pugi::xml_node worldbody) {
  const WalkerColors colors = walker_colors(index);
  add_torso(walker, colors, add_mocap_body(worldbody, walker_name(walker.id, "torso")));
  add_leg(walker, "left", colors.trousers, worldbody);
  add_leg(walker, "right", colors.trousers, worldbody);
}

double rope_height_m(const Tow& tow, const Walker& walker) {
  return std::min(0.7 * tow.height_m, walker.leg_length_m);
}

void add_tow(const Tow& tow, const Walker& walker, pugi::xml_node worldbody, pugi::xml_node tendon) {
  constexpr double kRopeEnd_kg = 1e5;  // against it the pull of any rope is nothing
  const double knot_m = rope_height_m(tow, walker);
  const pugi::xml_node cylinder =
      MjcfElement(worldbody, "body").set("name", tow_name(tow.id, "cylinder")).node();
  add_slides(cylinder);
  MjcfElement(cylinder, "geom")
      .set("type", "cylinder")
      .set_role(kSeenPulled)
      .set("pos", {0.0, 0.0, 0.5 * tow.height_m})
      .set("size", {tow.radius_m, 0.5 * tow.height_m})
      .set("mass", {tow.mass_kg})
      .set("friction", {tow.friction, 0.0, 0.0})
      .set_color(kTowColor);
  const std::string knot = tow_name(tow.id, "cylinder_end");
  MjcfElement(cylinder, "site").set("name", knot).set("pos", {0.0, 0.0, knot_m}).set("size", {0.012});
  const std::string end = tow_name(tow.id, "walker_end");
  const pugi::xml_node hand = MjcfElement(worldbody, "body").set("name", end).node();
  MjcfElement(hand, "inertial")
      .set("pos", {0.0, 0.0, 0.0})
      .set("mass", {kRopeEnd_kg})
      .set("diaginertia", {1.0, 1.0, 1.0});
  add_slides(hand);
  MjcfElement(hand, "site").set("name", end).set("size", {0.012});
  const pugi::xml_node rope = MjcfElement(tendon, "spatial")
                                  .set("name", tow_name(tow.id, "rope"))
                                  .set("limited", "true")
                                  .set("range", {0.0, tow.taut_m()})
                                  .set("width", {0.012})
                                  .set_color(kRopeColor)
                                  .node();
  MjcfElement(rope, "site").set("site", end);
  MjcfElement(rope, "site").set("site", knot);
}

}  // namespace scanbed::sim
