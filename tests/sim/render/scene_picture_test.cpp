// SPDX-License-Identifier: MIT
#include "sim/render/scene_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <string>

#include "core/errors/input_error.hpp"
#include "sim/spatial/appearance.hpp"
#include "tests/support/hall.hpp"
#include "tests/support/pixels.hpp"

namespace scanbed::sim {
namespace {

constexpr int kWidth_px = 960;
constexpr int kHeight_px = 720;
constexpr int kLegendTop_px = 686;

// The hall, 14 x 9 m, fills the plan's frame: 960 pixels less 2 x 6 % of 720 for its width leave
// 873.6 / 14 = 62.4 pixels a metre, and 54 pixels above and 72 below leave its middle at row 351.
Eigen::Vector2d in_plan(const Eigen::Vector2d& p_W) {
  return {480.0 + 62.4 * p_W.x(), 351.0 - 62.4 * (p_W.y() - 4.5)};
}

// The laser stands at (0, 0.45, 0.28) and looks along y; 30 degrees up is the upper edge.
Eigen::Vector2d in_lasers_eye(const Eigen::Vector3d& p_W) {
  const double px_per_unit = 360.0 / std::tan(radians(30.0));
  const double ahead_m = p_W.y() - 0.45;
  return {480.0 + px_per_unit * p_W.x() / ahead_m, 360.0 - px_per_unit * (p_W.z() - 0.28) / ahead_m};
}

class ScenePictureTest : public ::testing::Test {
 protected:
  Image paint(View view, const Features& features) {
    ScenePainter painter(world_, {kWidth_px, kHeight_px, view});
    return painter.paint(state_, {test_hall_scan(world_, state_), features}, "hall");
  }

  World world_ = test_hall();
  WorldState state_ = test_hall_state(world_);
  Features features_ = test_hall_features(world_, state_);
};

// Light changes how bright a colour is, hardly which.
void expect_hue(const Eigen::Vector3d& shown, const Rgb& color) {
  EXPECT_LT((shown.normalized() - color.normalized()).norm(), 0.1) << shown.transpose();
}

TEST_F(ScenePictureTest, HasTheSizeAskedFor) {
  for (const View view : {View::kTop, View::kCamera, View::kLaser}) {
    ScenePainter painter(world_, {321, 200, view});
    const Image image = painter.paint(state_, {{}, {}}, "");
    EXPECT_EQ(image.width_px, 321);
    EXPECT_EQ(image.height_px, 200);
    EXPECT_EQ(image.rgb.size(), 3U * 321 * 200);
  }
}

TEST_F(ScenePictureTest, ThePlanShowsThingsWhereTheyAre) {
  const Image image = paint(View::kTop, {});
  expect_hue(pixel(image, in_plan({2.0, 4.0})), solid_color(world_.solids[1]));
  expect_hue(pixel(image, in_plan({-2.0, 4.0})), solid_color(world_.solids[1]));
  expect_hue(pixel(image, in_plan({-4.0, 7.0})), solid_color(world_.solids[5]));  // the bench's seat
  expect_hue(pixel(image, in_plan({-0.25, 2.8})), kTowColor);
}

TEST_F(ScenePictureTest, TheLasersEyeShowsThingsWhereTheyAre) {
  const Image image = paint(View::kLaser, {});
  expect_hue(pixel(image, in_lasers_eye({2.0, 3.75, 1.0})), solid_color(world_.solids[1]));
  expect_hue(pixel(image, in_lasers_eye({-0.25, 2.55, 0.8})), kTowColor);
}

TEST_F(ScenePictureTest, ThePlanShowsFeaturesInTheirColours) {
  const Image image = paint(View::kTop, features_);
  for (const Eigen::Vector2d& p_W : {Eigen::Vector2d(-5.0, 9.0), {5.5, 9.0}, {7.0, 5.0}, {-7.0, 2.0}}) {
    EXPECT_TRUE(is_red(pixel(image, in_plan(p_W)))) << p_W.transpose();
  }
  for (const Eigen::Vector2d& center : {Eigen::Vector2d(2, 4), {-2, 4}, {-4.6, 7}, {3.4, 7}, {-0.25, 2.8}}) {
    EXPECT_TRUE(is_green(pixel(image, in_plan(center + Eigen::Vector2d(0.25, 0.0))))) << center.transpose();
    EXPECT_TRUE(is_green(pixel(image, in_plan(center + Eigen::Vector2d(0.0, -0.25))))) << center.transpose();
  }
  for (const WalkerState& walker : state_.walkers) {
    EXPECT_TRUE(is_purple(pixel(image, in_plan(walker.left_leg_m))));
    EXPECT_TRUE(is_purple(pixel(image, in_plan(walker.right_leg_m))));
  }
}

TEST_F(ScenePictureTest, TheLasersEyeShowsFeaturesInTheirColours) {
  const Image image = paint(View::kLaser, features_);
  // Lines lie a little above and below the laser's plane: 0.05 m at 8.55 m; legs show at their middle.
  EXPECT_TRUE(is_red(pixel(image, in_lasers_eye({0.9, 9.0, 0.33}))));
  EXPECT_TRUE(shows_near(image, in_lasers_eye({2.0, 3.75, 0.33}), 3.0, is_green));
  const Eigen::Vector2d leg = state_.walkers[0].left_leg_m;
  EXPECT_TRUE(shows_near(image, in_lasers_eye({leg.x(), leg.y() - 0.11, 0.33}), 3.0, is_purple));
}

TEST_F(ScenePictureTest, OnlyFeaturesHaveTheirColours) {
  for (const View view : {View::kTop, View::kCamera, View::kLaser}) {
    const Image without = paint(view, {});
    EXPECT_EQ(count_pixels(without, 0, kLegendTop_px, is_red), 0);
    EXPECT_EQ(count_pixels(without, 0, kLegendTop_px, is_green), 0);
    EXPECT_EQ(count_pixels(without, 0, kLegendTop_px, is_purple), 0);
    const Image with = paint(view, features_);
    EXPECT_GT(count_pixels(with, 0, kLegendTop_px, is_red), 500);
    EXPECT_GT(count_pixels(with, 0, kLegendTop_px, is_green), 300);
    EXPECT_GT(count_pixels(with, 0, kLegendTop_px, is_purple), 100);
  }
}

TEST_F(ScenePictureTest, TheSameSceneGivesTheSamePicture) {
  ScenePainter painter(world_, {320, 240, View::kCamera});
  const LaserScan scan = test_hall_scan(world_, state_);
  const Image first = painter.paint(state_, {scan, features_}, "hall");
  WorldState later = state_;
  later.X_WR.p_m.y() += 2.0;
  EXPECT_NE(painter.paint(later, {scan, features_}, "hall").rgb, first.rgb);
  EXPECT_EQ(painter.paint(state_, {scan, features_}, "hall").rgb, first.rgb);
}

TEST_F(ScenePictureTest, AWalkerThatLeftIsNotShown) {
  state_.walkers[1].present = false;
  const Image image = paint(View::kTop, {});
  const Eigen::Vector3d floor = pixel(image, in_plan({4.9, 2.6}));
  EXPECT_GT(floor.minCoeff(), 0.6);  // no shirt, no trousers, no shadow
}

TEST_F(ScenePictureTest, AnEmptyWorldAndAnEmptyScanMakeAPicture) {
  LaserScan scan;
  scan.geometry.num_beams = 0;
  for (const View view : {View::kTop, View::kCamera, View::kLaser}) {
    ScenePainter painter(World{}, {320, 240, view});
    const Image image = painter.paint({}, {scan, {}}, "");
    EXPECT_EQ(image.rgb.size(), 3U * 320 * 240);
  }
}

TEST_F(ScenePictureTest, OddIdsAndCaptionsMakeAPicture) {
  world_.solids[1].id = "<col & \"L\">";
  world_.walkers[0].id = "\xff'";
  world_.walkers[0].tow->id = "a/b\n";
  ScenePainter painter(world_, {320, 240, View::kCamera});
  EXPECT_EQ(painter.paint(state_, {{}, {}}, "<&\"\xff\n").width_px, 320);
}

TEST(PictureOptionsTest, DefaultsAreValid) {
  EXPECT_NO_THROW(PictureOptions{}.validate());
}

std::string refusal(const PictureOptions& options) {
  try {
    ScenePainter painter(World{}, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PictureOptionsTest, SizesOutOfRangeAreNamed) {
  for (const int size_px : {-5, 0, 63, 4097}) {
    EXPECT_NE(refusal({.width_px = size_px}).find("picture.width_px: value " + std::to_string(size_px)),
              std::string::npos);
    EXPECT_NE(refusal({.height_px = size_px}).find("picture.height_px: value " + std::to_string(size_px)),
              std::string::npos);
  }
  EXPECT_EQ(refusal({.width_px = 64, .height_px = 64}), "");
}

}  // namespace
}  // namespace scanbed::sim
