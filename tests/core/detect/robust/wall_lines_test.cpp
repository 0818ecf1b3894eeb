// SPDX-License-Identifier: MIT
#include "core/detect/robust/wall_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using Eigen::Vector2d;
using testing::IdealScene;
using testing::with_noise;

// Lines of a scan that is cut into surfaces and these into pieces.
std::vector<Line> lines_of(const LaserScan& scan, const DetectorOptions& options = robust_options()) {
  Echoes echoes;
  EchoReader().read(scan, options.surface, echoes);
  SurfaceRuns runs;
  SurfaceSplitter().split(echoes, options.surface, runs);
  RayLineSums sums;
  sums.build(echoes);
  LineSplitter splitter;
  splitter.begin(echoes, sums, options.surface);
  for (int i = 0; i < runs.num_runs(); ++i) splitter.add(runs.run(i));
  splitter.split();
  std::vector<LinePiece> pieces;
  for (int i = 0; i < runs.num_runs(); ++i) splitter.append_pieces(runs.run(i), pieces);
  std::vector<Line> lines;
  WallLines walls;
  walls.begin(echoes, sums, options);
  walls.append(pieces, lines);
  return lines;
}

double from_y_axis_rad(const Line& line) {
  const Vector2d along_m = line.right_m - line.left_m;
  return std::atan(along_m.x() / along_m.y());
}

TEST(WallLinesTest, EndsLieOnTheWallAtTheBeamsThatSawThem) {
  IdealScene scene;
  scene.wall({3.0, -2.0}, {3.0, 1.0});
  const LaserScan scan = scene.scan();
  const std::vector<Line> lines = lines_of(scan);
  ASSERT_EQ(lines.size(), 1u);
  for (const auto& [beam, end_m] :
       {std::pair(lines[0].beams.first, lines[0].left_m), std::pair(lines[0].beams.last, lines[0].right_m)}) {
    EXPECT_NEAR(end_m.x(), 3.0, 1e-9);
    EXPECT_NEAR(end_m.y(), 3.0 * std::tan(scan.geometry.bearing_rad(beam)), 1e-9);
  }
  EXPECT_FALSE(lines[0].slope);
}

// A post hides most of what a long wall leaves at its end.
IdealScene wall_with_a_short_rest() {
  IdealScene scene;
  scene.wall({5.0, -4.0}, {5.0, 0.5});
  scene.wall({2.0, 0.2}, {2.0, 0.6});
  scene.wall({5.0, 1.5}, {5.0, 1.9});
  return scene;
}

TEST(WallLinesTest, AShortPieceTakesItsDirectionFromTheRestOfItsWall) {
  const LaserScan ideal = wall_with_a_short_rest().scan();
  for (unsigned seed = 0; seed < 100; ++seed) {
    const std::vector<Line> lines = lines_of(with_noise(ideal, 0.01, seed));
    bool is_found = false;
    for (const Line& line : lines) {
      if (line.left_m.y() < 1.4) continue;
      is_found = true;
      // Alone it would be uncertain by some 2 degrees; together both are so by less than a tenth of one.
      EXPECT_NEAR(from_y_axis_rad(line), 0.0, radians(0.4)) << seed;
      EXPECT_GE((line.right_m - line.left_m).norm(), 0.25) << seed;  // beams meet it every 5 cm; ends may go
    }
    EXPECT_TRUE(is_found) << seed;
  }
}

TEST(WallLinesTest, AWallThatIsSetBackKeepsItsOwnDirection) {
  IdealScene scene;
  scene.wall({5.0, -4.0}, {5.0, 0.5});
  scene.wall({2.0, 0.2}, {2.0, 0.6});
  const double turn = std::tan(radians(20.0));
  scene.wall({5.0 - 0.2 * turn, 1.5}, {5.0 + 0.2 * turn, 1.9});  // crosses the line of the long one
  double sum_rad = 0.0;
  constexpr int kNumScans = 50;
  for (unsigned seed = 0; seed < kNumScans; ++seed) {
    for (const Line& line : lines_of(with_noise(scene.scan(), 0.005, seed))) {
      if (line.left_m.y() > 1.4) sum_rad += from_y_axis_rad(line) / kNumScans;
    }
  }
  EXPECT_NEAR(sum_rad, radians(20.0), radians(1.0));  // 4 sigma of a mean of 50 are 0.5 degrees
}

TEST(WallLinesTest, APieceWhoseDirectionIsUncertainIsNoLine) {
  IdealScene scene;
  scene.wall({5.0, 1.5}, {5.0, 1.9});
  const LaserScan scan = with_noise(scene.scan(), 0.01, 1);
  DetectorOptions options = robust_options();
  EXPECT_EQ(lines_of(scan, options).size(), 1u);
  options.surface.max_direction_sigma_rad = radians(0.5);
  EXPECT_TRUE(lines_of(scan, options).empty());
}

TEST(WallLinesTest, AnEchoBeyondACornerDoesNotTurnAShortPiece) {
  IdealScene scene;
  scene.wall({4.0, 0.0}, {4.0, 0.35});
  LaserScan scan = scene.scan();
  int last = scan.num_beams() - 1;
  while (!scan.has_echo(last)) --last;
  constexpr double kBeyond_m = 0.05;
  scan.range_m[last] -= kBeyond_m;
  double sum_rad = 0.0;
  constexpr int kNumScans = 200;
  for (unsigned seed = 0; seed < kNumScans; ++seed) {
    const std::vector<Line> lines = lines_of(with_noise(scan, 0.006, seed));
    ASSERT_EQ(lines.size(), 1u) << seed;
    sum_rad += from_y_axis_rad(lines[0]) / kNumScans;
  }
  // 10 echoes on 0.35 m have a sum of squared positions of 0.10 m2. An error at one end, weighed with its
  // position there, would turn them by 0.05 * 0.175 / 0.1 = 0.09 rad.
  EXPECT_NEAR(sum_rad, 0.0, 0.02);  // it stays where noise hides it; 4 sigma of the mean are 0.005
}

}  // namespace
}  // namespace scanbed
