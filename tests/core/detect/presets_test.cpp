// SPDX-License-Identifier: MIT
#include "core/detect/presets.hpp"

#include <gtest/gtest.h>

namespace scanbed {
namespace {

TEST(PresetsTest, EveryNameStandsForOptionsThatValidate) {
  for (const std::string& name : preset_names()) {
    const std::optional<DetectorOptions> options = preset_options(name);
    ASSERT_TRUE(options) << name;
    EXPECT_NO_THROW(options->validate()) << name;
  }
  EXPECT_EQ(preset_options("paper")->pipeline, Pipeline::kPaper);
  EXPECT_EQ(preset_options("robust")->pipeline, Pipeline::kRobust);
}

TEST(PresetsTest, OtherNamesStandForNothing) {
  EXPECT_FALSE(preset_options("Paper"));
  EXPECT_FALSE(preset_options(""));
}

}  // namespace
}  // namespace scanbed
