// SPDX-License-Identifier: MIT
#include "core/score/visibility.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;

TEST(VisibilityTest, UnobstructedBeamsAreThoseBetweenTheTangents) {
  // At 2 m a radius of 0.25 m spans 2 asin(1/8) = 14.36 degrees: beams at -7..7 degrees, every half degree.
  EXPECT_EQ(num_unobstructed_beams({2.0, 0.0}, 0.25, {}), 29);
  // Also where the field of view ends: half of them would lie beyond its edge.
  EXPECT_EQ(num_unobstructed_beams({0.0, -2.0}, 0.25, {}), 29);
  EXPECT_EQ(num_unobstructed_beams({0.1, 0.0}, 0.25, {}), 720);
}

Visibility visibility_of(const IdealScene& scene, int object) {
  return scene.truth().objects[object].visibility;
}

TEST(VisibilityTest, AColumnInPlainViewIsResolvable) {
  IdealScene scene;
  const int column = scene.cylinder({3.0, 0.0}, 0.25);
  EXPECT_EQ(visibility_of(scene, column), Visibility::kResolvable);
  EXPECT_EQ(scene.truth().objects[column].num_clean_beams, 19);  // asin(1/12) = 4.78 degrees to each side
}

TEST(VisibilityTest, AColumnThatIsPartlyHiddenOrCutIsMarginal) {
  IdealScene hidden;
  const int column = hidden.cylinder({3.0, 0.0}, 0.25);
  hidden.cylinder({1.5, 0.12}, 0.04);
  EXPECT_EQ(visibility_of(hidden, column), Visibility::kMarginal);
  IdealScene cut;
  const int at_edge = cut.cylinder({0.0, -3.0}, 0.25);
  EXPECT_EQ(visibility_of(cut, at_edge), Visibility::kMarginal);
}

TEST(VisibilityTest, FewerThanThreeBeamsAreHidden) {
  IdealScene scene;
  const int behind = scene.cylinder({4.0, 0.0}, 0.1);
  scene.cylinder({2.0, 0.0}, 0.3);
  EXPECT_EQ(visibility_of(scene, behind), Visibility::kHidden);
}

TEST(VisibilityTest, LegsNeedFourCleanBeamsAndCirclesSix) {
  for (const auto& [primitive, expected] : {std::pair{Primitive::kLeg, Visibility::kResolvable},
                                            std::pair{Primitive::kCircle, Visibility::kMarginal}}) {
    IdealScene scene;
    const int object = scene.cylinder({2.8, 0.0}, 0.06, primitive);  // 2.46 degrees: 5 beams
    EXPECT_EQ(visibility_of(scene, object), expected);
  }
}

TEST(VisibilityTest, MixedBeamsAreInViewButNotClean) {
  IdealScene scene;
  const int leg = scene.cylinder({2.8, 0.0}, 0.06, Primitive::kLeg);
  Truth truth = scene.truth();
  for (auto& beam : truth.beams) beam.mixed = beam.object == leg;
  classify_visibility(truth, scene.scan());
  EXPECT_EQ(truth.objects[leg].num_clean_beams, 0);
  EXPECT_EQ(truth.objects[leg].visibility, Visibility::kMarginal);
}

TEST(VisibilityTest, WallsAreResolvableByTheirPieces) {
  IdealScene scene;
  const int wall = scene.wall({2.0, -1.0}, {2.0, 1.0});
  const int stub = scene.wall({1.0, 1.5}, {1.0, 1.6});
  EXPECT_EQ(visibility_of(scene, wall), Visibility::kResolvable);
  EXPECT_EQ(visibility_of(scene, stub), Visibility::kMarginal);
}

}  // namespace
}  // namespace scanbed
