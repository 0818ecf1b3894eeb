// SPDX-License-Identifier: MIT
#include "core/interpret/interpreter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/detect/feature_detector.hpp"
#include "core/errors/input_error.hpp"
#include "core/track/tracker.hpp"
#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

constexpr double kPeriod_s = 0.1;

// Two bench feet ahead, a column beside them, and a cylinder of their size that rolls by: while it passes the
// column it is at a bench's distance from it for a while.
LaserScan hall(double time_s) {
  testing::IdealScene scene;
  scene.wall({-1.0, -3.8}, {6.0, -3.8});
  scene.wall({6.0, -3.8}, {6.0, 3.5});
  scene.cylinder({4.0, -2.0}, 0.25);
  scene.cylinder({4.0, -0.8}, 0.25);
  scene.cylinder({4.0, 2.5}, 0.25);
  scene.cylinder({1.0 + 0.5 * time_s, 1.7}, 0.25);
  LaserScan scan = testing::with_noise(scene.scan(), 0.003, static_cast<unsigned>(1000 * time_s));
  scan.time_s = time_s;
  return scan;
}

int count(const Scene& scene, SceneKind kind) {
  return static_cast<int>(std::count_if(scene.objects.begin(), scene.objects.end(),
                                        [kind](const auto& o) { return o.kind == kind; }));
}

TEST(InterpreterTest, AMovingCylinderIsNeverPartOfABench) {
  FeatureDetector detector(robust_options());
  Tracker tracker;
  Interpreter interpreter;
  int num_benches = 0;
  bool was_at_a_benchs_distance = false;
  for (int i = 0; i < 90; ++i) {
    const double time_s = kPeriod_s * i;
    const LaserScan scan = hall(time_s);
    const Features& features = detector.detect(scan);
    const Scene& scene = interpreter.interpret(scan, features, tracker.update(scan, features));
    const Eigen::Vector2d moving_m(1.0 + 0.5 * time_s, 1.7);
    was_at_a_benchs_distance |= std::abs((moving_m - Eigen::Vector2d(4.0, 2.5)).norm() - 1.2) < 0.02;
    for (const SceneObject& object : scene.objects) {
      if (object.kind != SceneKind::kBench) continue;
      ++num_benches;
      EXPECT_NEAR((object.center_m - Eigen::Vector2d(4.0, -1.4)).norm(), 0.0, 0.05) << time_s;
      for (const FeatureRef& ref : scene.from_of(object)) {
        EXPECT_GT((features.circles[ref.index].center_m - moving_m).norm(), 0.3) << time_s;
      }
    }
    const int least = i > 15 ? 1 : 0;  // until then nothing was seen to stand for long enough
    EXPECT_GE(count(scene, SceneKind::kBench), least) << time_s;
    EXPECT_LE(count(scene, SceneKind::kBench), 1) << time_s;
    EXPECT_EQ(count(scene, SceneKind::kCorner), 1) << time_s;
  }
  EXPECT_TRUE(was_at_a_benchs_distance);
  EXPECT_GT(num_benches, 70);
}

TEST(InterpreterTest, WithoutTracksThereIsNoBench) {
  FeatureDetector detector(robust_options());
  const LaserScan scan = hall(0.0);
  Interpreter interpreter;
  const Scene& scene = interpreter.interpret(scan, detector.detect(scan), {});
  EXPECT_EQ(count(scene, SceneKind::kBench), 0);
  EXPECT_GE(count(scene, SceneKind::kColumn), 3);
  EXPECT_EQ(count(scene, SceneKind::kWall), 2);
}

// A room with an open door and a wall that a column hides in the middle, seen all around.
LaserScan room_around() {
  testing::IdealScene room({.num_beams = 720, .first_rad = -kPi, .step_rad = kPi / 360});
  room.wall({3.0, -2.0}, {3.0, -0.45});
  room.wall({3.0, 0.45}, {3.0, 2.0});
  room.wall({8.0, -4.0}, {8.0, 4.0});
  room.wall({3.0, 2.0}, {-3.0, 2.0});
  room.wall({-3.0, 2.0}, {-3.0, -2.0});
  room.wall({-3.0, -2.0}, {3.0, -2.0});
  room.cylinder({-1.8, 0.3}, 0.2);
  return testing::with_noise(room.scan(), 0.002, 3);
}

/// The objects of a scan as text, in an order that does not depend on where the scan begins.
std::vector<std::string> told(const LaserScan& scan) {
  FeatureDetector detector(robust_options());
  Interpreter interpreter;
  const Scene& scene = interpreter.interpret(scan, detector.detect(scan), {});
  std::vector<std::string> texts;
  for (const SceneObject& object : scene.objects) {
    std::string text(to_string(object.kind));
    for (const Eigen::Vector2d& p_m : {object.center_m, object.left_m, object.right_m}) {
      for (const double value_m : p_m) text += " " + std::to_string(std::lround(value_m * 1e4));
    }
    texts.push_back(text + (object.is_open ? " open" : "") + (object.is_outer ? " outer" : "") + " of " +
                    std::to_string(object.num_from));
  }
  std::sort(texts.begin(), texts.end());
  return texts;
}

LaserScan begun_at(const LaserScan& scan, int beam) {
  LaserScan begun = scan;
  std::rotate(begun.range_m.begin(), begun.range_m.begin() + beam, begun.range_m.end());
  begun.geometry.first_rad = scan.geometry.bearing_rad(beam);
  return begun;
}

TEST(InterpreterTest, ASceneAllAroundDoesNotDependOnWhereTheScanBegins) {
  const LaserScan scan = room_around();
  FeatureDetector detector(robust_options());
  Interpreter interpreter;
  const Scene& scene = interpreter.interpret(scan, detector.detect(scan), {});
  EXPECT_EQ(count(scene, SceneKind::kDoor), 1);
  EXPECT_EQ(count(scene, SceneKind::kCorner), 4);
  EXPECT_EQ(count(scene, SceneKind::kWall), 5);  // of the room four, and one behind the door
  const std::vector<std::string> expected = told(scan);
  for (int beam = 0; beam < scan.num_beams(); beam += 3) {
    EXPECT_EQ(told(begun_at(scan, beam)), expected) << "begun at beam " << beam;
  }
}

TEST(InterpreterTest, NothingIsAnEmptyScene) {
  Interpreter interpreter;
  EXPECT_TRUE(interpreter.interpret({}, {}, {}).objects.empty());
}

TEST(InterpreterTest, NewOptionsAreChecked) {
  Interpreter interpreter;
  InterpretOptions options;
  options.bench_gap_m = -1.0;
  EXPECT_THROW(interpreter.set_options(options), InputError);
  EXPECT_THROW(Interpreter{options}, InputError);
}

}  // namespace
}  // namespace scanbed
