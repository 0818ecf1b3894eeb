// SPDX-License-Identifier: MIT
#include "scenarios/report/feature_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scanbed::scenarios {
namespace {

std::string line_of(const LaserScan& scan, const Features& features) {
  std::string out;
  append_feature_line(out, {scan, features});
  return out;
}

Features one_of_each() {
  Features features;
  features.lines.push_back({.beams = {0, 58},
                            .left_m = {0.0, -3.57},
                            .right_m = {1.98, -3.58},
                            .slope = -0.002,
                            .bias_m = -3.57,
                            .num_points = 59,
                            .error_m = 0.004,
                            .score = 0.99,
                            .covariance = Eigen::Matrix2d{{1e-6, -1.0 / 3e7}, {-1.0 / 3e7, 2e-5}}});
  features.circles.push_back({.beams = {120, 140},
                              .center_m = {3.0, 1.2},
                              .radius_m = 0.25,
                              .average_rad = 1.91,
                              .std_rad = 0.03,
                              .score = 0.97});
  features.legs.push_back({.beams = {200, 206}, .middle_m = {2.1, 0.4}, .score = 0.8});
  return features;
}

TEST(FeatureLineTest, HasThePublicKeys) {
  EXPECT_EQ(line_of(LaserScan{}, one_of_each()),
            R"({"scan":0,"t_s":0,"features":[)"
            R"({"type":"line","first":0,"last":58,"left":[0,-3.57],"right":[1.98,-3.58],"slope":-0.002,)"
            R"("bias":-3.57,"points":59,"error":0.004,"score":0.99,)"
            R"("covariance":[1e-06,-3.33333e-08,-3.33333e-08,2e-05]},)"
            R"({"type":"circle","first":120,"last":140,"center":[3,1.2],"radius":0.25,"average":1.91,)"
            R"("std":0.03,"score":0.97,"covariance":null},)"
            R"({"type":"leg","first":200,"last":206,"middle":[2.1,0.4],"score":0.8}]})"
            "\n");
}

// The robust pipeline compares models, and has no inscribed angles.
TEST(FeatureLineTest, WhatACircleDoesNotHaveIsNull) {
  Features features;
  features.circles.push_back({.radius_m = 0.25});
  EXPECT_NE(line_of(LaserScan{}, features).find(R"("radius":0.25,"average":null,"std":null,)"),
            std::string::npos);
}

TEST(FeatureLineTest, PrintsTracksWhereThereAre) {
  const std::vector<Track> tracks = {{.id = 7,
                                      .kind = TrackKind::kPerson,
                                      .position_m = {2.0, 0.3},
                                      .velocity_m_per_s = {0.9, 0.1},
                                      .score = 0.9},
                                     {.id = 9, .kind = TrackKind::kCylinder, .radius_m = 0.25, .score = 1.0},
                                     {.id = 11, .kind = TrackKind::kLeg, .score = 0.5}};
  std::string out;
  append_feature_line(out, {LaserScan{}, {}, &tracks});
  EXPECT_EQ(out, R"({"scan":0,"t_s":0,"features":[],"tracks":[)"
                 R"({"id":7,"kind":"person","position":[2,0.3],"velocity":[0.9,0.1],"score":0.9},)"
                 R"({"id":9,"kind":"cylinder","position":[0,0],"velocity":[0,0],"radius":0.25,"score":1},)"
                 R"({"id":11,"kind":"leg","position":[0,0],"velocity":[0,0],"score":0.5}]})"
                 "\n");
}

TEST(FeatureLineTest, CountsASceneFromFeaturesAsTheyArePrinted) {
  Features features = one_of_each();
  features.circles.push_back({.beams = {60, 70}});  // printed before the first circle
  Scene scene;
  scene.from = {{Primitive::kCircle, 0}, {Primitive::kCircle, 1}, {Primitive::kLine, 0}};
  scene.objects = {{.kind = SceneKind::kBench,
                    .center_m = {5.2, -3.4},
                    .radius_m = 0.2,
                    .score = 0.9,
                    .first_from = 0,
                    .num_from = 2},
                   {.kind = SceneKind::kDoor, .is_open = true, .first_from = 2, .num_from = 1},
                   {.kind = SceneKind::kCorner, .is_outer = true},
                   {.kind = SceneKind::kWall},
                   {.kind = SceneKind::kColumn},
                   {.kind = SceneKind::kTrashCan}};
  std::string out;
  append_feature_line(out, {LaserScan{}, features, nullptr, &scene});
  const std::string ends = R"("left":[0,0],"right":[0,0],)";
  EXPECT_EQ(
      out.substr(out.find(",\"scene\"")),
      R"(,"scene":[{"kind":"bench","center":[5.2,-3.4],)" + ends +
          R"("radius":0.2,"from":[2,1],"score":0.9},{"kind":"door","center":[0,0],"open":true,)" + ends +
          R"("from":[0],"score":0},{"kind":"corner","center":[0,0],"corner":"outer","from":[],"score":0},)"
          R"({"kind":"wall","center":[0,0],)" +
          ends +
          R"("from":[],"score":0},{"kind":"column","center":[0,0],"radius":0,"from":[],"score":0},)"
          R"({"kind":"trash_can","center":[0,0],"radius":0,"from":[],"score":0}]})"
          "\n");
}

TEST(FeatureLineTest, IsAnObjectWithoutFeaturesToo) {
  LaserScan scan;
  scan.index = 7;
  scan.time_s = 1125000000.123456;
  EXPECT_EQ(line_of(scan, {}), "{\"scan\":7,\"t_s\":1125000000.123456,\"features\":[]}\n");
}

TEST(FeatureLineTest, OrdersFeaturesByTheirFirstBeam) {
  Features features = one_of_each();
  features.legs[0].beams = {60, 65};
  features.lines[0].beams = {150, 180};
  const std::string line = line_of(LaserScan{}, features);
  EXPECT_LT(line.find("leg"), line.find("circle"));
  EXPECT_LT(line.find("circle"), line.find("\"line\""));
}

TEST(FeatureLineTest, WritesNullForALineAlongY) {
  Features features;
  features.lines.push_back({.beams = {1, 9}, .slope = {}, .bias_m = {}});
  EXPECT_NE(line_of(LaserScan{}, features).find(R"("slope":null,"bias":null)"), std::string::npos);
}

TEST(FeatureLineTest, RoundsToAMicrometreAndKnowsNoMinusZero) {
  Features features;
  features.legs.push_back({.beams = {1, 9}, .middle_m = {0.12345678, -1e-9}, .score = 1.0 / 3.0});
  EXPECT_NE(line_of(LaserScan{}, features).find(R"("middle":[0.123457,0],"score":0.333333)"),
            std::string::npos);
}

TEST(FeatureLineTest, WritesNullForWhatJsonCannotHold) {
  Features features;
  features.legs.push_back(
      {.beams = {1, 9}, .middle_m = {std::numeric_limits<double>::infinity(), std::nan("")}, .score = 0.0});
  EXPECT_NE(line_of(LaserScan{}, features).find(R"("middle":[null,null])"), std::string::npos);
}

TEST(FeatureLineTest, WritesTheGreatestNumbersAsTheyAre) {
  LaserScan scan;
  scan.time_s = -1e308;
  EXPECT_NE(line_of(scan, {}).find(R"("t_s":-1e+308,)"), std::string::npos);
}

}  // namespace
}  // namespace scanbed::scenarios
