// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "core/geometry/angles.hpp"
#include "scenarios/load/load_scenario.hpp"
#include "sim/sensor/simulated_lms.hpp"
#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

using Eigen::Vector2d;
using testing::kHead;
using testing::write_file;

const std::string kMap =
    "image: hall.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\nnegate: 0\n";

// A picture of what is inside: black on white, `width` x `height` cells; the middle of a cell decides.
std::string pgm(int width, int height, const std::function<bool(const Vector2d&)>& inside) {
  std::string text = "P5 " + std::to_string(width) + " " + std::to_string(height) + " 255\n";
  for (int row = height - 1; row >= 0; --row) {
    for (int column = 0; column < width; ++column) {
      text += inside({column + 0.5, row + 0.5}) ? '\0' : '\xfe';
    }
  }
  return text;
}

class LoadMapTest : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) { write_file(folder_ / name, text); }
  Scenario load(const std::string& rest) {
    write("main.yaml", kHead + rest);
    return load_scenario(folder_ / "main.yaml");
  }
  // What the loader says of a map, without the folder.
  std::string error(const std::string& map,
                    const std::string& rest = "world: [{id: hall, map: hall.yaml}]\n") {
    write("hall.yaml", map);
    std::string text = testing::error_of([&] { load(rest); });
    const std::string folder = (folder_ / "").string();
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder)) {
      text.erase(at, folder.size());
    }
    return text;
  }
  // One scan without noise, at the sensor's highest resolution.
  LaserScan scan(const Scenario& scenario) {
    sim::SimulatedLms lms(scenario.world, {.lms = scenario.lms, .duration_s = 0.1});
    LaserScan scan;
    EXPECT_TRUE(lms.next(scan, RangeSensor::Seconds(0)));
    return scan;
  }

  testing::TemporaryFolder folder_;
};

const std::string kIdeal =
    "sensor: {effects: {noise: 0, bias: 0, spot: 0, dropout: 0, dazzle: 0}}\n"
    "world: [{id: hall, map: hall.yaml}]\n";
constexpr double kWordStep_m = 0.001;

TEST_F(LoadMapTest, ARoomOfWholeCellsIsExact) {
  // 6 x 4 m with walls of one cell, inside from (0.05, 0.05) to (5.95, 3.95).
  write("hall.pgm",
        pgm(120, 80, [](const Vector2d& p) { return p.x() < 1 || p.y() < 1 || p.x() > 119 || p.y() > 79; }));
  write("hall.yaml", kMap);
  const Scenario scenario = load(kIdeal + "robot: {pose: [3, 0.5, 90]}\n");
  const LaserScan seen = scan(scenario);
  for (std::size_t i = 0; i < seen.range_m.size(); ++i) {
    const double bearing_rad = kPi / 2 + seen.geometry.bearing_rad(static_cast<int>(i));
    const Vector2d u(std::cos(bearing_rad), std::sin(bearing_rad));
    const double to_side_m = 2.95 / std::max(std::abs(u.x()), 1e-9);
    const double to_end_m = u.y() > 1e-9 ? 3.45 / u.y() : 1e9;
    EXPECT_NEAR(seen.range_m[i], std::min(to_side_m, to_end_m), kWordStep_m) << i;
  }
}

TEST_F(LoadMapTest, OriginPlacesAndTurnsTheMap) {
  // A bar of 1 x 0.1 m at the map's lowest left corner, which lies at (2, 1), turned by 90 degrees.
  write("hall.pgm", pgm(40, 40, [](const Vector2d& p) { return p.x() < 20 && p.y() < 2; }));
  write("hall.yaml",
        "image: hall.pgm\nresolution: 0.05\norigin: [2, 1, 1.5707963267948966]\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.196\nnegate: false\nmode: trinary\n");
  const Scenario scenario = load("world: [{id: bar, map: hall.yaml, label: fence, top: 1.2}]\n");
  ASSERT_EQ(scenario.world.solids.size(), 1u);
  const sim::Solid& bar = scenario.world.solids[0];
  EXPECT_EQ(bar.id, "bar.0");
  EXPECT_EQ(bar.label, "fence");
  EXPECT_EQ(bar.top_m, 1.2);
  const auto& walls = std::get<sim::WallChain>(bar.shape);
  EXPECT_TRUE(walls.closed);
  ASSERT_EQ(walls.corners_m.size(), 4u);
  for (const Vector2d& corner : {Vector2d(2, 1), Vector2d(2, 2), Vector2d(1.9, 2), Vector2d(1.9, 1)}) {
    EXPECT_TRUE(std::any_of(walls.corners_m.begin(), walls.corners_m.end(), [&](const Vector2d& c) {
      return (c - corner).norm() < 1e-12;
    })) << corner.transpose();
  }
}

// A slanting wall and a round column, which no grid holds exactly.
TEST_F(LoadMapTest, AScanIsThatOfTheTrueShapesToWithinACell) {
  constexpr double kCell_m = 0.05;
  const Vector2d center_m(2.0, 2.6);
  constexpr double kRadius_m = 0.4;
  const Vector2d normal(std::sin(0.3), -std::cos(0.3));  // of a wall through (2, 4.5)
  const auto inside = [&](const Vector2d& cell) {
    const Vector2d p_m = kCell_m * cell;
    return (p_m - center_m).norm() < kRadius_m || (p_m - Vector2d(2.0, 4.5)).dot(normal) < 0.0;
  };
  write("hall.pgm", pgm(80, 140, inside));
  write("hall.yaml", kMap);
  const LaserScan seen = scan(load(kIdeal + "robot: {pose: [2, 0.5, 90]}\n"));
  int num_checked = 0;
  for (std::size_t i = 0; i < seen.range_m.size(); ++i) {
    if (!std::isfinite(seen.range_m[i])) continue;
    const double bearing_rad = kPi / 2 + seen.geometry.bearing_rad(static_cast<int>(i));
    const Vector2d p_m =
        Vector2d(2.0, 0.5) + seen.range_m[i] * Vector2d(std::cos(bearing_rad), std::sin(bearing_rad));
    if (p_m.x() < 0.1 || p_m.x() > 3.9 || p_m.y() > 6.9) continue;  // the map's own edge
    const double off_column_m = std::abs((p_m - center_m).norm() - kRadius_m);
    const double off_wall_m = std::abs((p_m - Vector2d(2.0, 4.5)).dot(normal));
    EXPECT_LT(std::min(off_column_m, off_wall_m), kCell_m) << i;
    ++num_checked;
  }
  EXPECT_GT(num_checked, 60);
}

TEST_F(LoadMapTest, ThresholdsAndNegationSayWhatIsOccupied) {
  // Shades 0, 88, 90, 255: occupied by 1, 0.655, 0.647, 0.
  write("hall.pgm", "P2 8 1 255\n0 255 88 255 90 255 255 255\n");
  const auto num_walls = [&](const std::string& map) {
    write("hall.yaml", map);
    return load("world: [{id: hall, map: hall.yaml}]\nrobot: {pose: [5, 5, 0]}\n").world.solids.size();
  };
  EXPECT_EQ(num_walls(kMap), 2u);
  std::string strict = kMap;
  strict.replace(strict.find("0.65"), 4, "0.66");
  EXPECT_EQ(num_walls(strict), 1u);
  std::string negated = kMap;
  negated.replace(negated.find("negate: 0"), 9, "negate: 1");
  EXPECT_EQ(num_walls(negated), 3u);  // the white ones; the last three are one
}

TEST_F(LoadMapTest, AnIncludedFileFindsItsMapBesideIt) {
  std::filesystem::create_directory(folder_ / "inner");
  write("inner/hall.pgm", "P2 2 1 255 0 255");
  write("inner/hall.yaml", kMap);
  write("inner/world.yaml", "world: [{id: hall, map: hall.yaml}]\n");
  EXPECT_EQ(load("include: inner/world.yaml\nrobot: {pose: [5, 5, 0]}\n").world.solids.size(), 1u);
}

TEST_F(LoadMapTest, TellsWhatIsWrongWithPlace) {
  write("hall.pgm", "P2 2 1 255 0 255");
  EXPECT_EQ(error(kMap, "world: [{id: hall, map: no.yaml}]\n"),
            "main.yaml:4:25: no file 'no.yaml' beside this one or in the library");
  EXPECT_EQ(error(kMap, "world: [{id: hall, map: /etc/passwd}]\n").substr(0, 16), "main.yaml:4:25: ");
  EXPECT_EQ(error(kMap, "world: [{id: hall, map: hall.yaml, box: {at: [0, 0, 0], size: [1, 1]}}]\n"),
            "main.yaml:4:25: map: a second shape beside 'box'");
  EXPECT_EQ(error(kMap, "world: [{id: hall, map: hall.yaml, closed: true}]\n"),
            "main.yaml:4:36: unknown key 'closed'; known keys: use, walls, cylinder, box, polygon, map, id, "
            "label, bottom, top, material");
  EXPECT_EQ(error("image: hall.pgm\n"), "hall.yaml:1:1: map: missing key 'resolution'");
  EXPECT_EQ(error(kMap + "thresh: 1\n").substr(0, 31), "hall.yaml:7:1: unknown key 'thr");
  EXPECT_EQ(error("image: ../hall.pgm\n"),
            "hall.yaml:1:8: '../hall.pgm': expected a file beside this one or of the library, without '..'");
  EXPECT_EQ(error(kMap + "mode: raw\n"),
            "hall.yaml:7:7: mode: unknown value 'raw'; known values: trinary, scale");
  std::string swapped = kMap;
  swapped.replace(swapped.find("0.196"), 5, "0.7");
  EXPECT_EQ(error(swapped), "hall.yaml:5:14: free_thresh: is greater than occupied_thresh");
  write("hall.pgm", "P2 2 1 255 0");
  EXPECT_EQ(error(kMap), "hall.yaml:1:8: image: hall.pgm: byte 12: the file is cut off");
  write("hall.pgm", "P5 70000 70000 255\n");
  EXPECT_EQ(error(kMap),
            "hall.yaml:1:8: image: hall.pgm: the image is too large: 70000 x 70000 pixels; allowed: 16777216 "
            "in all");
  write("hall.pgm", "P2 2 1 255 255 255");
  EXPECT_EQ(error(kMap), "main.yaml:4:25: map: the map has no occupied cell");
  std::string dots = "P2 240 240 1";
  for (int row = 0; row < 240; ++row) {
    for (int column = 0; column < 240; ++column) dots += row % 2 == 0 && column % 2 == 0 ? " 0" : " 1";
  }
  write("hall.pgm", dots);
  EXPECT_EQ(error(kMap).substr(0, 45), "hall.yaml:1:8: image: more than 10000 walls; ");
}

}  // namespace
}  // namespace scanbed::scenarios
