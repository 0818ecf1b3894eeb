// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

using testing::parse;
using testing::parse_error;

const std::string kPath = "path: {line: [[5, 5], [9, 5]]}";

sim::Walker walker(const std::string& item) {
  return parse("actors:\n  - " + item + "\n").world.walkers.at(0);
}

std::string actor_error(const std::string& item) {
  return parse_error("actors:\n  - " + item + "\n");
}

TEST(LoadActorsTest, TakesEveryKeyOfAWalker) {
  const sim::Walker ann = walker(
      "{id: ann, use: walker, speed: 1.1, leg_radius: 0.07, leg_length: 0.9, "
      "step_width: 0.12, height: 1.6, start: {after: 1.5}, " +
      kPath + "}");
  EXPECT_EQ(ann.id, "ann");
  EXPECT_EQ(ann.speed_m_per_s, 1.1);
  EXPECT_EQ(ann.leg_radius_m, 0.07);
  EXPECT_EQ(ann.leg_length_m, 0.9);
  EXPECT_EQ(ann.step_width_m, 0.12);
  EXPECT_EQ(ann.height_m, 1.6);
  EXPECT_EQ(ann.start_s, 1.5);
  EXPECT_FALSE(ann.path.loop);
  EXPECT_FALSE(ann.path.leave);
  EXPECT_FALSE(ann.tow.has_value());
  EXPECT_EQ(ann.path.points_m.at(1), Eigen::Vector2d(9.0, 5.0));
}

TEST(LoadActorsTest, DressesPersons) {
  const sim::Walker child = walker("{id: kim, use: walker, person: child, clothing: skirt, " + kPath + "}");
  EXPECT_LT(child.height_m, 1.4);
  EXPECT_GT(child.material.roughness_m, 0.0);
  const sim::Walker man =
      walker("{id: kim, use: walker, person: man, speed: 0.8, leg_radius: 0.09, " + kPath + "}");
  EXPECT_GT(man.height_m, 1.5);
  EXPECT_EQ(man.speed_m_per_s, 0.8) << "what the file says goes before the body drawn";
  EXPECT_EQ(man.leg_radius_m, 0.09);
  EXPECT_EQ(actor_error("{id: a, use: walker, clothing: skirt, " + kPath + "}"),
            "f:5:36: clothing: goes with person, whose legs it covers");
}

TEST(LoadActorsTest, DrawsBodiesFromTheSeed) {
  const std::string text = testing::kHead + "actors: [{id: a, use: walker, person: man, " + kPath + "}]\n";
  const auto height = [&](const char* seed) {
    return parse_scenario(text, "f", std::vector<Setting>{{"seed", seed}}).world.walkers.at(0).height_m;
  };
  EXPECT_EQ(height("1"), height("1"));
  EXPECT_NE(height("1"), height("2"));
}

TEST(LoadActorsTest, TakesWhatWalkersDoOnTheirWay) {
  const sim::Walker ann = walker(
      "{id: ann, use: walker, lateral: 0.4, avoids: true, material: dark_cloth, "
      "stops: [{at: 1, for: 4, turn_deg: 90}, {at: 2, for: forever}], " +
      kPath + "}");
  EXPECT_EQ(ann.lateral_m, 0.4);
  EXPECT_TRUE(ann.avoids);
  EXPECT_EQ(ann.material.reflectivity, 0.08);
  ASSERT_EQ(ann.stops.size(), 2u);
  EXPECT_EQ(ann.stops[0].at_m, 1.0);
  EXPECT_EQ(ann.stops[0].for_s, 4.0);
  EXPECT_NEAR(ann.stops[0].turn_rad, kPi / 2, 1e-15);
  EXPECT_TRUE(std::isinf(ann.stops[1].for_s));
  EXPECT_EQ(actor_error("{id: a, use: walker, stops: [{at: 2}, {at: 1}], " + kPath + "}").substr(0, 36),
            "f:5:5: walker 'a': stop 1: at_m: val");
}

TEST(LoadActorsTest, ReadsPaths) {
  const auto path = [](const std::string& text) {
    return walker("{id: ann, use: walker, path: " + text + "}").path;
  };
  const sim::Path loop = path("{loop: [[5, 5], [9, 5], [9, 9]], round: 0.5}");
  EXPECT_TRUE(loop.loop);
  EXPECT_EQ(loop.round_m, 0.5);
  EXPECT_TRUE(path("{line: [[5, 5], [9, 5]], then: leave}").leave);
  EXPECT_FALSE(path("{line: [[5, 5], [9, 5]], then: stand}").leave);
}

TEST(LoadActorsTest, TakesEveryKeyOfATow) {
  const sim::Tow tow = walker("{id: ann, use: walker, " + kPath +
                              ", tows: {id: cyl, cylinder: {r: 0.2, height: 0.8}, rope: 0.7, label: bin, "
                              "mass: 5, friction: 0.4}}")
                           .tow.value();
  EXPECT_EQ(tow.id, "cyl");
  EXPECT_EQ(tow.radius_m, 0.2);
  EXPECT_EQ(tow.height_m, 0.8);
  EXPECT_EQ(tow.rope_m, 0.7);
  EXPECT_EQ(tow.label, "bin");
  EXPECT_EQ(tow.mass_kg, 5.0);
  EXPECT_EQ(tow.friction, 0.4);
}

TEST(LoadActorsTest, RefusesPathsThatAreNotOneThing) {
  const auto path_error = [](const std::string& text) {
    return actor_error("{id: a, use: walker, path: " + text + "}");
  };
  EXPECT_EQ(path_error("{}"), "f:5:32: path: a path is exactly one of loop and line");
  EXPECT_EQ(path_error("{loop: [[5, 5], [9, 5]], then: leave}"),
            "f:5:63: then: a loop has no end; it goes with line");
  EXPECT_EQ(path_error("{line: [[5, 5], [9, 5]], then: vanish}"),
            "f:5:63: then: unknown value 'vanish'; known values: stand, leave");
  EXPECT_EQ(path_error("{line: [[5, 5]]}"), "f:5:39: line: expected at least 2 points, found 1");
}

TEST(LoadActorsTest, RefusesActorsThatCannotBe) {
  EXPECT_EQ(actor_error("{id: a, use: walker}"), "f:5:5: actors: missing key 'path'");
  EXPECT_EQ(actor_error("{id: a, " + kPath + "}"), "f:5:5: actors: missing key 'use'");
  EXPECT_EQ(actor_error("{id: a, use: walker, speed: 9, " + kPath + "}"),
            "f:5:33: speed: value 9 is out of range; allowed: (0, 5]");
  EXPECT_EQ(actor_error("{id: a, use: walker, sped: 1, " + kPath + "}"),
            "f:5:26: unknown key 'sped'; did you mean 'speed'?");
  EXPECT_EQ(actor_error("{id: a, use: walker, " + kPath + ", tows: {id: c, cylinder: {r: 0}}}"),
            "f:5:86: r: value 0 is out of range; allowed: (0, 1000]");
  EXPECT_EQ(actor_error("{id: a, use: walker, " + kPath + ", tows: {id: c, cylinder: {r: 0.2}, rope: 0}}"),
            "f:5:98: rope: value 0 is out of range; allowed: (0, 1000]");
}

}  // namespace
}  // namespace scanbed::scenarios
