// SPDX-License-Identifier: MIT
#include "core/errors/input_error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace scanbed {
namespace {

TEST(InputErrorTest, RequireIsSilentWhereTheConditionHolds) {
  EXPECT_NO_THROW(require(true, "x", 1.0, "> 0"));
}

TEST(InputErrorTest, RequireNamesParameterValueAndAllowedRange) {
  try {
    require(false, "circle_std_max", 3.5, "(0, 0.402] rad");
    FAIL() << "did not throw";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "circle_std_max: value 3.5 is out of range; allowed: (0, 0.402] rad");
  }
}

}  // namespace
}  // namespace scanbed
