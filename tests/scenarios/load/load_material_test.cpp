// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

std::string post(const std::string& material) {
  return "world:\n  - {id: post, cylinder: {at: [3, 0], r: 0.1}, material: " + material + "}\n";
}

sim::Material material(const std::string& text) {
  return testing::parse(post(text)).world.solids.at(0).material;
}

TEST(LoadMaterialTest, TakesANameOrAMapThatChangesIt) {
  EXPECT_EQ(material("black_cardboard").reflectivity, 0.1);
  EXPECT_TRUE(material("glass").glass);
  const sim::Material bark = material("{use: bark, reflectivity: 0.2}");
  EXPECT_EQ(bark.reflectivity, 0.2);
  EXPECT_EQ(bark.roughness_m, 0.010);
  const sim::Material own = material("{reflectivity: 0.7, glass: true, roughness: 0.02}");
  EXPECT_EQ(own.reflectivity, 0.7);
  EXPECT_TRUE(own.glass);
  EXPECT_EQ(own.roughness_m, 0.02);
}

TEST(LoadMaterialTest, RefusesWhatIsNoMaterial) {
  EXPECT_EQ(testing::parse_error(post("glas")),
            "f:5:58: material: unknown value 'glas'; did you mean 'glass'?");
  EXPECT_EQ(testing::parse_error(post("{reflectivity: 0}")),
            "f:5:73: reflectivity: value 0 is out of range; allowed: (0, 1]");
  EXPECT_EQ(testing::parse_error(post("{rough: 0}")),
            "f:5:59: unknown key 'rough'; known keys: use, reflectivity, glass, roughness");
}

}  // namespace
}  // namespace scanbed::scenarios
