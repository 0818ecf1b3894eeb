// SPDX-License-Identifier: MIT
#include "core/interpret/round_groups.hpp"

#include <gtest/gtest.h>

#include "tests/core/track/made_features.hpp"
#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::circle_at;

Scene scene_of(const std::vector<Circle>& circles, CircleMotion motion,
               const LaserScan& scan = testing::open_scan(0.0)) {
  Scene scene;
  const std::vector<CircleMotion> motions(circles.size(), motion);
  RoundGroups().find({scan, circles, motions}, {}, scene);
  return scene;
}

TEST(RoundGroupsTest, TwoFeetAtTheBenchsDistanceAreABench) {
  const Scene scene =
      scene_of({circle_at({3.0, -0.6}, 0.25), circle_at({5.0, 3.0}, 0.25), circle_at({3.0, 0.6}, 0.26)},
               CircleMotion::kSettled);
  ASSERT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(scene.objects[0].kind, SceneKind::kBench);
  EXPECT_NEAR((scene.objects[0].center_m - Eigen::Vector2d(3.0, 0.0)).norm(), 0.0, 1e-9);
  ASSERT_EQ(scene.objects[0].num_from, 2);
  EXPECT_EQ(scene.from_of(scene.objects[0])[0], (FeatureRef{Primitive::kCircle, 0}));
  EXPECT_EQ(scene.from_of(scene.objects[0])[1], (FeatureRef{Primitive::kCircle, 2}));
  EXPECT_EQ(scene.objects[1].kind, SceneKind::kColumn);
}

TEST(RoundGroupsTest, FeetThatWereNotSeenToStandAreNoBench) {
  const std::vector<Circle> feet = {circle_at({3.0, -0.6}, 0.25), circle_at({3.0, 0.6}, 0.25)};
  for (const SceneObject& object : scene_of(feet, CircleMotion::kUnknown).objects) {
    EXPECT_EQ(object.kind, SceneKind::kColumn);
  }
  EXPECT_TRUE(scene_of(feet, CircleMotion::kMobile).objects.empty());
}

TEST(RoundGroupsTest, AFootBelongsToOneBench) {
  const Scene scene =
      scene_of({circle_at({3.0, -1.22}, 0.25), circle_at({3.0, 0.0}, 0.25), circle_at({3.0, 1.2}, 0.25)},
               CircleMotion::kSettled);
  ASSERT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(scene.objects[0].kind, SceneKind::kBench);
  EXPECT_EQ(scene.from_of(scene.objects[0])[0].index, 1);  // the pair that fits best
  EXPECT_EQ(scene.objects[1].kind, SceneKind::kColumn);
}

TEST(RoundGroupsTest, UnlikeFeetAreNoBench) {
  EXPECT_EQ(scene_of({circle_at({3.0, -0.6}, 0.25), circle_at({3.0, 0.6}, 0.34)}, CircleMotion::kSettled)
                .objects.size(),
            2u);
}

TEST(RoundGroupsTest, ASlimCylinderIsATrashCan) {
  const Scene scene = scene_of({circle_at({3.0, 0.0}, 0.15)}, CircleMotion::kSettled);
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_EQ(scene.objects[0].kind, SceneKind::kTrashCan);
}

TEST(RoundGroupsTest, TwoArcsOfOneColumnAreOneColumnRefinedOnBoth) {
  testing::IdealScene hall;
  hall.cylinder({3.0, 0.0}, 0.4);
  hall.cylinder({1.5, 0.0}, 0.05);  // a post hides its middle
  std::vector<Circle> arcs = {circle_at({3.06, -0.05}, 0.46), circle_at({2.97, 0.03}, 0.37)};
  arcs[0].beams = {166, 173};
  arcs[1].beams = {187, 194};
  const Scene scene = scene_of(arcs, CircleMotion::kSettled, hall.scan());
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_EQ(scene.objects[0].num_from, 2);
  EXPECT_NEAR((scene.objects[0].center_m - Eigen::Vector2d(3.0, 0.0)).norm(), 0.0, 1e-3);
  EXPECT_NEAR(scene.objects[0].radius_m, 0.4, 1e-3);
}

TEST(RoundGroupsTest, ColumnsThatStandCloseStayTwo) {
  EXPECT_EQ(scene_of({circle_at({3.0, -0.3}, 0.25), circle_at({3.0, 0.3}, 0.25)}, CircleMotion::kSettled)
                .objects.size(),
            2u);
}

}  // namespace
}  // namespace scanbed
