// SPDX-License-Identifier: MIT
#include "sim/spatial/mjcf_actors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "sim/spatial/part_names.hpp"
#include "sim/spatial/walker_body.hpp"

namespace scanbed::sim {
namespace {

class MjcfActorsTest : public ::testing::Test {
 protected:
  pugi::xml_node body(const std::string& name) const {
    return worldbody_.find_child_by_attribute("body", "name", name.c_str());
  }

  pugi::xml_document document_;
  pugi::xml_node worldbody_ = document_.append_child("worldbody");
  pugi::xml_node tendon_ = document_.append_child("tendon");
};

TEST_F(MjcfActorsTest, AWalkerHasTorsoAndTwoJointedLegs) {
  const Walker walker{.id = "ann", .leg_radius_m = 0.07, .leg_length_m = 0.9};
  add_walker(walker, 0, worldbody_);
  for (const char* part :
       {"torso", "left_foot", "left_shank", "left_thigh", "right_foot", "right_shank", "right_thigh"}) {
    EXPECT_STREQ(body(walker_name("ann", part)).attribute("mocap").value(), "true") << part;
  }
  std::istringstream reader(body(walker_name("ann", "left_shank")).child("geom").attribute("size").value());
  double radius_m = 0.0;
  reader >> radius_m;
  EXPECT_EQ(radius_m, 0.07);
}

TEST_F(MjcfActorsTest, ShankAndThighMakeUpTheLeg) {
  const WalkerBody body({.id = "ann", .leg_length_m = 0.9});
  EXPECT_DOUBLE_EQ(body.shank_m + body.thigh_m, 0.9);
}

TEST_F(MjcfActorsTest, TheRopeIsATendonAsLongAsRopeAndRadius) {
  const Walker walker{.id = "ann"};
  add_tow({.id = "cyl", .radius_m = 0.3, .height_m = 1.2, .rope_m = 0.9}, walker, worldbody_, tendon_);
  const pugi::xml_node cylinder = body(tow_name("cyl", "cylinder"));
  EXPECT_STREQ(cylinder.child("geom").attribute("size").value(), "0.3 0.6");
  for (const pugi::xml_node joint : cylinder.children("joint")) {
    EXPECT_STREQ(joint.attribute("type").value(), "slide");
  }
  const pugi::xml_node rope = tendon_.child("spatial");
  EXPECT_STREQ(rope.attribute("range").value(), "0 1.2");
  EXPECT_STREQ(rope.first_child().attribute("site").value(), tow_name("cyl", "walker_end").c_str());
  EXPECT_STREQ(rope.last_child().attribute("site").value(), tow_name("cyl", "cylinder_end").c_str());
}

TEST_F(MjcfActorsTest, RopesAreTiedWithinReachAndToTheCylinder) {
  const Walker walker{.id = "ann", .leg_length_m = 0.9};
  EXPECT_DOUBLE_EQ(rope_height_m({.id = "cyl", .height_m = 1.0}, walker), 0.7);
  EXPECT_DOUBLE_EQ(rope_height_m({.id = "cyl", .height_m = 2.0}, walker), 0.9);
}

TEST_F(MjcfActorsTest, TheLaserSitsOnTheRobotAtItsHeight) {
  Robot robot;
  robot.X_RS = {{0.1, 0.02}, 0.5};
  robot.laser_height_m = 0.35;
  add_robot(robot, worldbody_);
  const pugi::xml_node laser = body("robot").child("body");
  EXPECT_STREQ(laser.attribute("pos").value(), "0.1 0.02 0.35");
  double w = 0.0;
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  std::istringstream(laser.attribute("quat").value()) >> w >> x >> y >> z;
  EXPECT_NEAR(w, std::cos(0.25), 1e-12);
  EXPECT_NEAR(std::hypot(x, y), 0.0, 1e-12);
  EXPECT_NEAR(z, std::sin(0.25), 1e-12);
}

}  // namespace
}  // namespace scanbed::sim
