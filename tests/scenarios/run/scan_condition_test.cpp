// SPDX-License-Identifier: MIT
#include "scenarios/run/scan_condition.hpp"

#include <gtest/gtest.h>

namespace scanbed::scenarios {
namespace {

Circle circle_at(double x_m, double y_m) {
  Circle circle;
  circle.center_m = {x_m, y_m};
  circle.radius_m = 0.25;
  return circle;
}

ObjectTruth column(const std::string& id, double x_m, double y_m) {
  ObjectTruth object;
  object.id = id;
  object.primitive = Primitive::kCircle;
  object.center_m = {x_m, y_m};
  object.radius_m = 0.25;
  object.visibility = Visibility::kResolvable;
  return object;
}

class ScanConditionTest : public ::testing::Test {
 protected:
  std::optional<bool> holds(const ScanCondition& condition) const {
    return scenarios::holds(condition, {scan_, features_, &truth_}, {});
  }
  std::optional<bool> near(const std::string& id, double within_m, int at_least = 1) const {
    return holds({.kind = FeatureKind::kCircle, .near = NearObject{id, within_m}, .at_least = at_least});
  }

  LaserScan scan_{.range_m = {kNoEcho}};
  Features features_;
  Truth truth_{.beams = {BeamTruth{}}};  // of the scan's one beam, on which all features stand
};

TEST_F(ScanConditionTest, CountsFeaturesOfItsKind) {
  features_.circles = {circle_at(1, 0), circle_at(2, 0)};
  EXPECT_TRUE(holds({.kind = FeatureKind::kCircle, .at_least = 2, .at_most = 2}).value());
  EXPECT_FALSE(holds({.kind = FeatureKind::kCircle, .at_least = 3}).value());
  EXPECT_FALSE(holds({.kind = FeatureKind::kCircle, .at_most = 1}).value());
  EXPECT_TRUE(holds({.kind = FeatureKind::kLeg, .at_most = 0}).value());
}

TEST_F(ScanConditionTest, CountsOnlyWhatIsNear) {
  truth_.objects = {column("cyl", 3, 4)};
  features_.circles = {circle_at(3.0, 4.1), circle_at(3.0, 4.3)};
  EXPECT_TRUE(near("cyl", 0.11).value());
  EXPECT_FALSE(near("cyl", 0.09).value());
  EXPECT_TRUE(near("cyl", 0.31, 2).value());
}

TEST_F(ScanConditionTest, MeansThePartsOfAThing) {
  truth_.objects = {column("bench.foot_0", 3, 4), column("bench_2", 8, 8)};
  features_.circles = {circle_at(3, 4)};
  EXPECT_TRUE(near("bench", 0.1).value());
  features_.circles = {circle_at(8, 8)};
  EXPECT_FALSE(near("bench", 0.1).value());
}

TEST_F(ScanConditionTest, FindsNothingNearWhatIsNotThere) {
  truth_.objects = {column("late", 0, 0)};  // truth's place for what is not in the world yet
  features_.circles = {circle_at(0.1, 0)};
  EXPECT_FALSE(near("late", 5.0).value());
}

TEST_F(ScanConditionTest, MeasuresLinesFromTheirNearestPoint) {
  Line line;
  line.left_m = {0, 1};
  line.right_m = {4, 1};
  features_.lines = {line};
  truth_.objects = {column("post", 2, 1.5)};
  const auto line_near = [&](const std::string& id, double within_m) {
    return holds({.kind = FeatureKind::kLine, .near = NearObject{id, within_m}, .at_least = 1}).value();
  };
  EXPECT_TRUE(line_near("post", 0.51));
  EXPECT_FALSE(line_near("post", 0.49));
  ObjectTruth wall;
  wall.id = "hall.0";
  wall.primitive = Primitive::kLine;
  wall.from_m = {-9, 1.1};
  wall.to_m = {9, 1.1};
  truth_.objects = {wall};
  EXPECT_TRUE(line_near("hall", 0.11));
  EXPECT_FALSE(line_near("hall", 0.09));
}

TEST_F(ScanConditionTest, HoldsSharesOfThisScanAlone) {
  truth_.objects = {column("a", 3, 0), column("b", 5, 0)};
  features_.circles = {circle_at(3, 0), circle_at(9, 0)};
  EXPECT_TRUE(holds({.kind = FeatureKind::kCircle, .recall = 0.5}).value());
  EXPECT_FALSE(holds({.kind = FeatureKind::kCircle, .recall = 0.51}).value());
  EXPECT_TRUE(holds({.kind = FeatureKind::kCircle, .precision = 0.5}).value());
  EXPECT_FALSE(holds({.kind = FeatureKind::kCircle, .precision = 0.51}).value());
  EXPECT_FALSE(holds({.kind = FeatureKind::kCircle, .at_least = 3, .recall = 0.5}).value());
}

TEST_F(ScanConditionTest, CannotTellWhereThereIsNothingToMeasure) {
  EXPECT_FALSE(holds({.kind = FeatureKind::kCircle, .recall = 0.5}).has_value());
  EXPECT_FALSE(holds({.kind = FeatureKind::kCircle, .precision = 0.5}).has_value());
  const ScanCondition near{.kind = FeatureKind::kCircle, .near = NearObject{"a", 1.0}, .at_least = 1};
  EXPECT_FALSE(scenarios::holds(near, {scan_, features_, nullptr}, {}).has_value());
  const ScanCondition count{.kind = FeatureKind::kCircle, .at_most = 0};
  EXPECT_TRUE(scenarios::holds(count, {scan_, features_, nullptr}, {}).value());
  EXPECT_FALSE(holds({.kind = SceneKind::kBench, .at_most = 0}).has_value()) << "nothing was interpreted";
}

TEST_F(ScanConditionTest, CountsAndPlacesObjectsOfTheScene) {
  Scene scene;
  scene.objects = {{.kind = SceneKind::kBench, .left_m = {2, 1}, .right_m = {2, 2}},
                   {.kind = SceneKind::kColumn, .center_m = {5, 0}}};
  truth_.objects = {column("cyl", 2.1, 1.5), column("far", 5, 0.3)};
  const auto holds = [&](const ScanCondition& condition) {
    return scenarios::holds(condition, {scan_, features_, &truth_, nullptr, &scene}, {}).value();
  };
  EXPECT_TRUE(holds({.kind = SceneKind::kBench, .at_least = 1, .at_most = 1}));
  EXPECT_TRUE(holds({.kind = SceneKind::kBench, .near = NearObject{"cyl", 0.11}, .at_least = 1}));
  EXPECT_FALSE(holds({.kind = SceneKind::kBench, .near = NearObject{"cyl", 0.09}, .at_least = 1}));
  EXPECT_TRUE(holds({.kind = SceneKind::kColumn, .near = NearObject{"far", 0.31}, .at_least = 1}));
  EXPECT_TRUE(holds({.kind = SceneKind::kDoor, .at_most = 0}));
}

}  // namespace
}  // namespace scanbed::scenarios
