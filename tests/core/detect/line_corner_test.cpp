// SPDX-License-Identifier: MIT
#include "core/detect/line_corner.hpp"

#include <gtest/gtest.h>

#include "core/detect/feature_detector.hpp"
#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using Eigen::Vector2d;
using testing::IdealScene;
using testing::with_noise;

Line line(BeamSpan beams, const Vector2d& left_m, const Vector2d& right_m) {
  return {.beams = beams, .left_m = left_m, .right_m = right_m};
}

// Beams of the default geometry, half a degree apart from -90 degrees on: the corner is at beam 270.
TEST(LineCornerTest, IsWhereNeighboursMeet) {
  const Line a = line({200, 269}, {2.0, -0.5}, {2.0, 1.97});
  const Line b = line({271, 330}, {1.97, 2.0}, {-1.0, 2.0});
  const auto corner_m = corner_of({a, b, {270, 270}}, {});
  ASSERT_TRUE(corner_m);
  EXPECT_NEAR((*corner_m - Vector2d(2.0, 2.0)).norm(), 0.0, 1e-12);
  EXPECT_FALSE(corner_of({a, b, {270, 275}}, {})) << "something else lies between them";
}

TEST(LineCornerTest, LimitsSayWhatIsOne) {
  const Line a = line({200, 269}, {2.0, -0.5}, {2.0, 1.97});
  const Line flat = line({271, 330}, {1.99, 2.03}, {1.0, 4.5});  // 22 degrees on
  EXPECT_FALSE(corner_of({a, flat, {270, 270}}, {}));
  EXPECT_TRUE(corner_of({a, flat, {270, 270}}, {}, {.min_angle_rad = radians(20.0)}));
  // Something nearer, whose line meets the first one 0.7 m before its end.
  const Line nearer = line({271, 330}, {1.4, 1.425}, {-1.0, 2.0});
  EXPECT_FALSE(corner_of({a, nearer, {270, 270}}, {}));
  EXPECT_TRUE(corner_of({a, nearer, {270, 270}}, {}, {.reach_m = 1.0}));
}

TEST(LineCornerTest, LinesOfARoomEndAtItsCorners) {
  const Vector2d corners_m[] = {{-3.0, -2.0}, {4.0, -2.0}, {4.0, 1.0}, {5.0, 1.0}, {5.0, 3.0}, {-3.0, 3.0}};
  constexpr std::size_t kNumCorners = std::size(corners_m);
  for (const int num_beams : {360, 720, 1440}) {
    IdealScene room({.num_beams = num_beams, .first_rad = -kPi, .step_rad = 2.0 * kPi / num_beams});
    for (std::size_t i = 0; i < kNumCorners; ++i) {
      room.wall(corners_m[i], corners_m[(i + 1) % kNumCorners]);
    }
    const LaserScan ideal = room.scan();
    FeatureDetector detector(robust_options());
    for (unsigned seed = 0; seed < 20; ++seed) {
      const Features& found = detector.detect(with_noise(ideal, 0.005, seed));
      int num_ends = 0;
      for (const Line& wall : found.lines) {
        for (const Vector2d& end_m : {wall.left_m, wall.right_m}) {
          double nearest_m = 9.0;
          for (const std::size_t i : {0, 1, 4, 5}) {
            nearest_m = std::min(nearest_m, (end_m - corners_m[i]).norm());
          }
          if (nearest_m < 0.03) ++num_ends;
        }
      }
      // The wall from (4, 1) to (5, 1) is out of sight, so that its neighbours have one corner only.
      EXPECT_EQ(num_ends, 8) << num_beams << ' ' << seed;
    }
  }
}

// The wall behind ends where the nearer one hides it.
TEST(LineCornerTest, EndsAreLeftWhereThereIsNoCorner) {
  IdealScene scene;
  scene.wall({4.0, -4.0}, {4.0, 1.5});
  scene.wall({2.0, 0.5}, {2.6, 2.0});
  const LaserScan scan = scene.scan();
  FeatureDetector detector(robust_options());
  const Features& found = detector.detect(scan);
  ASSERT_EQ(found.lines.size(), 2u);
  for (const Line& wall : found.lines) {
    for (const auto& [beam, end_m] :
         {std::pair(wall.beams.first, wall.left_m), std::pair(wall.beams.last, wall.right_m)}) {
      EXPECT_NEAR(end_m.norm(), scan.range_m[beam], 1e-6);
    }
  }
}

}  // namespace
}  // namespace scanbed
