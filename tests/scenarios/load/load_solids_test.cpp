// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/geometry/angles.hpp"
#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

using testing::parse;
using testing::parse_error;

std::vector<sim::Solid> solids(const std::string& item) {
  return parse("world:\n  - " + item + "\n").world.solids;
}

// Items begin in line 5, column 5.
std::string solid_error(const std::string& item) {
  return parse_error("world:\n  - " + item + "\n");
}

TEST(LoadSolidsTest, ReadsWalls) {
  const sim::Solid hall = solids("{id: hall, walls: [[5, 5], [6, 5], [6, 6]], closed: true}").at(0);
  EXPECT_EQ(hall.id, "hall");
  EXPECT_EQ(hall.label, "wall");
  const auto& chain = std::get<sim::WallChain>(hall.shape);
  EXPECT_TRUE(chain.closed);
  EXPECT_EQ(chain.corners_m.at(1), Eigen::Vector2d(6.0, 5.0));
  const sim::Solid open = solids("{id: a, walls: [[5, 5], [6, 5]]}").at(0);
  EXPECT_FALSE(std::get<sim::WallChain>(open.shape).closed);
}

TEST(LoadSolidsTest, ReadsCylinders) {
  const sim::Solid column = solids("{id: c, cylinder: {at: [5, 5], r: 0.3}, label: column}").at(0);
  EXPECT_EQ(column.label, "column");
  EXPECT_EQ(std::get<sim::Cylinder>(column.shape).center_m, Eigen::Vector2d(5.0, 5.0));
  EXPECT_EQ(std::get<sim::Cylinder>(column.shape).radius_m, 0.3);
  EXPECT_EQ(solids("{id: c, cylinder: {at: [5, 5], r: 0.3}}").at(0).label, "cylinder");
}

TEST(LoadSolidsTest, ReadsBoxesAndPolygons) {
  const auto box = std::get<sim::Box>(solids("{id: b, box: {at: [5, 5, 90], size: [2, 1]}}").at(0).shape);
  EXPECT_DOUBLE_EQ(box.X_WB.theta_rad, kPi / 2);
  EXPECT_EQ(box.size_m, Eigen::Vector2d(2.0, 1.0));
  const sim::Solid polygon = solids("{id: p, polygon: [[5, 5], [6, 5], [5, 6]]}").at(0);
  EXPECT_EQ(std::get<sim::Polygon>(polygon.shape).corners_m.size(), 3u);
  EXPECT_EQ(polygon.label, "polygon");
}

TEST(LoadSolidsTest, ReadsHeightsAndMaterial) {
  const sim::Solid solid =
      solids("{id: c, cylinder: {at: [5, 5], r: 0.3}, bottom: 0.1, top: 1.5, material: {reflectivity: 0.9}}")
          .at(0);
  EXPECT_EQ(solid.bottom_m, 0.1);
  EXPECT_EQ(solid.top_m, 1.5);
  EXPECT_EQ(solid.material.reflectivity, 0.9);
}

TEST(LoadSolidsTest, BuildsABenchOfTwoFeetBelowASeat) {
  const std::vector<sim::Solid> bench =
      solids("{id: b, use: bench, at: [5, 6, 90], feet: {r: 0.25, apart: 1.2}, seat_z: 0.45}");
  ASSERT_EQ(bench.size(), 3u);
  // Turned by 90 degrees, the feet stand along y.
  const auto& foot_0 = std::get<sim::Cylinder>(bench[0].shape);
  const auto& foot_1 = std::get<sim::Cylinder>(bench[1].shape);
  EXPECT_TRUE(foot_0.center_m.isApprox(Eigen::Vector2d(5.0, 5.4), 1e-12));
  EXPECT_TRUE(foot_1.center_m.isApprox(Eigen::Vector2d(5.0, 6.6), 1e-12));
  EXPECT_EQ(foot_0.radius_m, 0.25);
  EXPECT_EQ(bench[0].id, "b.foot_0");
  EXPECT_EQ(bench[0].label, "bench");
  EXPECT_EQ(bench[0].top_m, 0.45);
  // The seat covers both feet and lies above a laser at 0.28 m.
  EXPECT_EQ(bench[2].id, "b.seat");
  EXPECT_EQ(bench[2].bottom_m, 0.45);
  EXPECT_TRUE(std::get<sim::Box>(bench[2].shape).size_m.isApprox(Eigen::Vector2d(1.7, 0.5), 1e-12));
}

TEST(LoadSolidsTest, BuildsAChairOfFourLegsBelowASeat) {
  const std::vector<sim::Solid> chair =
      solids("{id: c, use: chair, at: [5, 6, 0], size: 0.4, leg: 0.02, seat_z: 0.5}");
  ASSERT_EQ(chair.size(), 5u);
  EXPECT_TRUE(std::get<sim::Box>(chair[0].shape).X_WB.p_m.isApprox(Eigen::Vector2d(4.81, 5.81), 1e-12));
  EXPECT_EQ(chair[4].id, "c.seat");
  EXPECT_EQ(chair[4].bottom_m, 0.5);
  EXPECT_EQ(chair[0].label, "chair");
  EXPECT_EQ(solid_error("{id: c, use: chiar, at: [5, 6, 0]}"),
            "f:5:18: use: unknown value 'chiar'; did you mean 'chair'?");
}

TEST(LoadSolidsTest, RefusesShapesThatAreNotOneThing) {
  EXPECT_EQ(solid_error("{id: a}"),
            "f:5:5: world: no shape; one of walls, cylinder, box, polygon, map, use: bench, use: chair");
  EXPECT_EQ(solid_error("{id: a, walls: [[5, 5], [6, 5]], box: {at: [5, 5, 0], size: [1, 1]}}"),
            "f:5:43: box: a second shape beside 'walls'");
  EXPECT_EQ(solid_error("{id: a, cylindre: {at: [5, 5], r: 1}}"),
            "f:5:13: unknown key 'cylindre'; did you mean 'cylinder'?");
  EXPECT_EQ(
      solid_error("{id: a, cylinder: {at: [5, 5], r: 1}, closed: true}"),
      "f:5:43: unknown key 'closed'; known keys: use, walls, cylinder, box, polygon, map, id, label, bottom, "
      "top, material");
}

TEST(LoadSolidsTest, RefusesSizesThatCannotBe) {
  EXPECT_EQ(solid_error("{id: a, cylinder: {at: [5, 5], raduis: 1}}"), "f:5:23: cylinder: missing key 'r'");
  EXPECT_EQ(solid_error("{id: a, cylinder: {at: [5, 5], r: -1}}"),
            "f:5:39: r: value -1 is out of range; allowed: (0, 1000]");
  EXPECT_EQ(solid_error("{cylinder: {at: [5, 5], r: 1}}"), "f:5:5: world: missing key 'id'");
  EXPECT_EQ(solid_error("{id: a, walls: [[5, 5]]}"), "f:5:20: walls: expected at least 2 points, found 1");
  EXPECT_EQ(solid_error("{id: a, polygon: [[5, 5], [6, 5]]}"),
            "f:5:22: polygon: expected at least 3 points, found 2");
  EXPECT_EQ(solid_error("{id: a, cylinder: {at: [5, 5], r: 1}, bottom: 2, top: 1}"),
            "f:5:59: top: must be above the bottom, 2");
  EXPECT_EQ(solid_error("{id: a, use: bench, at: [5, 5, 0], feet: {r: 0.3, apart: 0.5}}"),
            "f:5:62: apart: the feet overlap; allowed: > 2 r");
  EXPECT_EQ(solid_error("{id: a, use: table, at: [5, 5, 0]}"),
            "f:5:18: use: unknown value 'table'; known values: bench, chair");
}

}  // namespace
}  // namespace scanbed::scenarios
