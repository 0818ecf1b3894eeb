// SPDX-License-Identifier: MIT
#include "sim/spatial/mjcf_solids.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "sim/spatial/part_names.hpp"

namespace scanbed::sim {
namespace {

std::vector<double> numbers(const pugi::xml_attribute& attribute) {
  std::istringstream reader(attribute.value());
  std::vector<double> values;
  for (double value = 0.0; reader >> value;) values.push_back(value);
  return values;
}

void expect_numbers(const pugi::xml_attribute& attribute, const std::vector<double>& expected) {
  const std::vector<double> values = numbers(attribute);
  ASSERT_EQ(values.size(), expected.size()) << attribute.name();
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_NEAR(values[i], expected[i], 1e-12) << attribute.name();
}

class MjcfSolidsTest : public ::testing::Test {
 protected:
  void add(const SolidShape& shape) {
    add_solid({.id = "s", .label = "box", .shape = shape, .bottom_m = 0.4, .top_m = 1.0}, worldbody_, asset_);
  }
  pugi::xml_node geom(int n) const {
    return worldbody_.find_child_by_attribute("geom", "name", solid_name("s", n).c_str());
  }

  pugi::xml_document document_;
  pugi::xml_node worldbody_ = document_.append_child("worldbody");
  pugi::xml_node asset_ = document_.append_child("asset");
};

TEST_F(MjcfSolidsTest, ACylinderStandsBetweenItsHeights) {
  add(Cylinder{{2, 4}, 0.25});
  EXPECT_STREQ(geom(0).attribute("type").value(), "cylinder");
  expect_numbers(geom(0).attribute("pos"), {2.0, 4.0, 0.7});
  expect_numbers(geom(0).attribute("size"), {0.25, 0.3});
}

TEST_F(MjcfSolidsTest, ABoxIsTurnedAboutItsCentre) {
  add(Box{{{1, 2}, 0.5}, {3.0, 0.8}});
  expect_numbers(geom(0).attribute("pos"), {1.0, 2.0, 0.7});
  expect_numbers(geom(0).attribute("euler"), {0.0, 0.0, 0.5});
  expect_numbers(geom(0).attribute("size"), {1.5, 0.4, 0.3});
}

TEST_F(MjcfSolidsTest, WallsOfAnOpenChainAreLongerOnlyWhereTheyMeet) {
  add(WallChain{{{0, 0}, {4, 0}, {4, 3}}});
  const double t = kWallThickness_m;
  expect_numbers(geom(0).attribute("size"), {2.0 + t / 4, t / 2, 0.3});
  expect_numbers(geom(0).attribute("pos"), {2.0 + t / 4, 0.0, 0.7});
  expect_numbers(geom(1).attribute("size"), {1.5 + t / 4, t / 2, 0.3});
  expect_numbers(geom(1).attribute("pos"), {4.0, 1.5 - t / 4, 0.7});
  expect_numbers(geom(1).attribute("euler"), {0.0, 0.0, kPi / 2});
  EXPECT_FALSE(geom(2));
}

TEST_F(MjcfSolidsTest, AClosedChainHasAWallBackToItsBeginning) {
  add(WallChain{{{0, 0}, {4, 0}, {4, 3}}, true});
  // From (4, 3) to (0, 0): 5 m, and half a thickness more at either end.
  expect_numbers(geom(2).attribute("size"), {2.5 + kWallThickness_m / 2, kWallThickness_m / 2, 0.3});
  expect_numbers(geom(2).attribute("pos"), {2.0, 1.5, 0.7});
}

TEST_F(MjcfSolidsTest, TheLaserMeetsTheLineOfAWallAndPicturesDoNotShowIt) {
  add(WallChain{{{0, 0}, {4, 0}, {4, 3}}});
  const pugi::xml_node sheet = worldbody_.find_child_by_attribute("geom", "name", sheet_name("s", 1).c_str());
  expect_numbers(sheet.attribute("pos"), {4.0, 1.5, 0.7});
  expect_numbers(sheet.attribute("size"), {1.5, 0.5 * kSheetThickness_m, 0.3});
  EXPECT_STREQ(sheet.attribute("group").value(), "3");
  EXPECT_STREQ(geom(1).attribute("group").value(), "1");
}

// Volume by the divergence theorem: right only if every face is there and turns outwards.
TEST_F(MjcfSolidsTest, APolygonBecomesAPrismOfTheRightVolume) {
  add(Polygon{{{0, 0}, {2, 0}, {2, 1}, {1, 2}, {0, 1}}});
  const pugi::xml_node mesh = asset_.child("mesh");
  EXPECT_STREQ(mesh.attribute("name").value(), geom(0).attribute("mesh").value());
  const std::vector<double> vertices = numbers(mesh.attribute("vertex"));
  const std::vector<double> faces = numbers(mesh.attribute("face"));
  ASSERT_EQ(vertices.size(), 30U);
  ASSERT_EQ(faces.size(), 3U * (2 * 5 + 2 * 3));
  const auto vertex = [&](double i) {
    const auto at = 3 * static_cast<std::size_t>(i);
    return Eigen::Vector3d(vertices.at(at), vertices.at(at + 1), vertices.at(at + 2));
  };
  double volume_m3 = 0.0;
  for (std::size_t i = 0; i < faces.size(); i += 3) {
    Eigen::Matrix3d corners;
    corners << vertex(faces[i]), vertex(faces[i + 1]), vertex(faces[i + 2]);
    volume_m3 += corners.determinant() / 6.0;
  }
  EXPECT_NEAR(volume_m3, 3.0 * 0.6, 1e-12);
}

}  // namespace
}  // namespace scanbed::sim
