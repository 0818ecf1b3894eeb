// SPDX-License-Identifier: MIT
#include "core/interpret/wall_groups.hpp"

#include <gtest/gtest.h>

#include "core/detect/feature_detector.hpp"
#include "core/geometry/angles.hpp"
#include "core/geometry/polar.hpp"
#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

struct Found {
  std::vector<SceneObject> walls, doors;
  Features features;
};

Found walls_in(const testing::IdealScene& hall) {
  const LaserScan scan = testing::with_noise(hall.scan(), 0.003, 4);
  FeatureDetector detector(robust_options());
  Found found{.features = detector.detect(scan)};
  Scene scene;
  WallGroups().find(scan, found.features.lines, {}, scene);
  for (const SceneObject& object : scene.objects) {
    (object.kind == SceneKind::kDoor ? found.doors : found.walls).push_back(object);
  }
  return found;
}

TEST(WallGroupsTest, AWallBehindAColumnIsOneWallInTwoPieces) {
  testing::IdealScene hall;
  hall.wall({4.0, -3.0}, {4.0, 3.0});
  hall.cylinder({2.0, 0.0}, 0.3);
  const Found found = walls_in(hall);
  EXPECT_EQ(found.features.lines.size(), 2u);  // what was measured stays as it is
  ASSERT_EQ(found.walls.size(), 1u);
  EXPECT_EQ(found.walls[0].num_from, 2);
  EXPECT_NEAR((found.walls[0].left_m - Eigen::Vector2d(4.0, -3.0)).norm(), 0.0,
              0.08);  // a beam's spacing at 5 m
  EXPECT_NEAR((found.walls[0].right_m - Eigen::Vector2d(4.0, 3.0)).norm(), 0.0, 0.08);
  EXPECT_TRUE(found.doors.empty());
}

TEST(WallGroupsTest, AnOpenDoorIsADoorInOneWall) {
  testing::IdealScene hall;
  hall.wall({3.0, -3.0}, {3.0, -0.45});
  hall.wall({3.0, 0.45}, {3.0, 3.0});
  hall.wall({7.0, -4.0}, {7.0, 4.0});
  const Found found = walls_in(hall);
  ASSERT_EQ(found.doors.size(), 1u);
  EXPECT_TRUE(found.doors[0].is_open);
  EXPECT_NEAR((found.doors[0].center_m - Eigen::Vector2d(3.0, 0.0)).norm(), 0.0, 0.04);
  EXPECT_NEAR((found.doors[0].right_m - found.doors[0].left_m).norm(), 0.9, 0.08);
  ASSERT_EQ(found.walls.size(), 2u);  // and the one behind
  EXPECT_EQ(found.walls[0].num_from + found.walls[1].num_from, 3);
}

TEST(WallGroupsTest, ADoorShutInItsFrameIsADoorToo) {
  testing::IdealScene hall;
  hall.wall({3.0, -3.0}, {3.0, -0.45});
  hall.wall({3.0, -0.45}, {3.15, -0.45});
  hall.wall({3.15, -0.45}, {3.15, 0.45});
  hall.wall({3.15, 0.45}, {3.0, 0.45});
  hall.wall({3.0, 0.45}, {3.0, 3.0});
  const Found found = walls_in(hall);
  ASSERT_EQ(found.doors.size(), 1u);
  EXPECT_FALSE(found.doors[0].is_open);
}

TEST(WallGroupsTest, WallsOfACrossingCorridorStayApart) {
  testing::IdealScene crossing;
  crossing.wall({-1.0, -1.1}, {2.0, -1.1});
  crossing.wall({5.0, -1.1}, {8.0, -1.1});
  for (const SceneObject& wall : walls_in(crossing).walls) EXPECT_EQ(wall.num_from, 1);
}

TEST(WallGroupsTest, ParallelWallsAreTwo) {
  testing::IdealScene hall;
  hall.wall({4.0, -3.0}, {4.0, 0.0});
  hall.wall({4.2, 0.0}, {4.2, 3.0});
  EXPECT_EQ(walls_in(hall).walls.size(), 2u);
}

TEST(WallGroupsTest, AShortPieceIsNoWall) {
  testing::IdealScene hall;
  hall.wall({2.0, -0.15}, {2.0, 0.15});
  EXPECT_TRUE(walls_in(hall).walls.empty());
}

// Bit by bit a round hall goes on straight; as a whole it does not.
TEST(WallGroupsTest, ACurveIsNotOneWall) {
  for (const double radius_m : {3.0, 4.0, 5.0}) {
    testing::IdealScene hall;
    constexpr int kNumEdges = 200;
    for (int i = 0; i < kNumEdges; ++i) {
      const double step_rad = kPi / kNumEdges;
      hall.wall(polar(i * step_rad - kPi / 2, radius_m), polar((i + 1) * step_rad - kPi / 2, radius_m));
    }
    const Found found = walls_in(hall);
    EXPECT_GT(found.features.lines.size(), 5u);
    for (const SceneObject& wall : found.walls) {
      EXPECT_GT((0.5 * (wall.left_m + wall.right_m)).norm(), radius_m - 0.2) << radius_m;
    }
  }
}

}  // namespace
}  // namespace scanbed
