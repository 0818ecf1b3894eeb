// SPDX-License-Identifier: MIT
#include "sim/world/materials.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/errors/input_error.hpp"

namespace scanbed::sim {
namespace {

TEST(MaterialsTest, EveryMaterialIsOneThatAWorldAccepts) {
  for (const std::string& name : material_names()) {
    World world;
    world.solids.push_back({"thing", "thing", Cylinder{{2, 0}, 0.2}, 0.0, 1.0, material_named(name)});
    EXPECT_NO_THROW(world.validate()) << name;
  }
}

TEST(MaterialsTest, PaperIsEightTimesAsBrightAsBlackCardboard) {
  EXPECT_DOUBLE_EQ(material_named("white_paper").reflectivity, 0.8);
  EXPECT_DOUBLE_EQ(material_named("black_cardboard").reflectivity, 0.1);
  EXPECT_TRUE(material_named("glass").glass);
  EXPECT_FALSE(material_named("steel").glass);
}

TEST(MaterialsTest, AnUnknownNameIsAnsweredWithTheKnownOnes) {
  try {
    material_named("cheese");
    FAIL();
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("'cheese'"), std::string::npos) << message;
    EXPECT_NE(message.find("glass"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace scanbed::sim
