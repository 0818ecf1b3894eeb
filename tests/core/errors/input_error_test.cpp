// SPDX-License-Identifier: MIT
#include "core/errors/input_error.hpp"

#include <gtest/gtest.h>

#include <array>
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

enum class Choice { kOff, kOn };

TEST(InputErrorTest, AChoiceIsOneOfItsWords) {
  constexpr std::array<std::string_view, 2> kWords = {"off", "on"};
  EXPECT_NO_THROW(require_choice(Choice::kOff, "x", kWords));
  EXPECT_NO_THROW(require_choice(Choice::kOn, "x", kWords));
  for (const int number : {-1, 2, 99}) {
    try {
      require_choice(static_cast<Choice>(number), "x", kWords);
      FAIL() << "accepts " << number;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()),
                "x: value " + std::to_string(number) + " is out of range; allowed: off, on");
    }
  }
}

}  // namespace
}  // namespace scanbed
