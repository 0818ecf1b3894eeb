// SPDX-License-Identifier: MIT
#include "scenarios/command/flag_values.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

using testing::error_of;

TEST(FlagValuesTest, ReadCountsTimesAndPaths) {
  EXPECT_EQ(to_count("--limit", "12", 1), 12);
  EXPECT_EQ(to_time_s("--at", "2.5"), 2.5);
  EXPECT_EQ(to_path("a/b"), std::filesystem::path("a/b"));
  EXPECT_EQ(to_path(""), std::nullopt);
}

TEST(FlagValuesTest, NameTheFlagAndTheTextThatDoesNotFit) {
  EXPECT_EQ(error_of([] { to_count("--limit", "many", 1); }),
            "--limit: expected a whole number, found 'many'");
  EXPECT_EQ(error_of([] { to_count("--limit", "-1", 0); }), "--limit: expected a whole number, found '-1'");
  EXPECT_EQ(error_of([] { to_count("--limit", "0", 1); }), "--limit: value 0 is out of range; allowed: >= 1");
  EXPECT_EQ(error_of([] { to_time_s("--at", ""); }), "--at: expected seconds, found ''");
}

TEST(FlagValuesTest, ChooseAmongNamesAndHintAtTheNearest) {
  const std::array<std::string, 2> views = {"top", "camera"};
  EXPECT_EQ(to_choice("--view", "camera", views, "views"), 1u);
  EXPECT_EQ(error_of([&] { to_choice("--view", "camra", views, "views"); }),
            "--view: unknown value 'camra'; did you mean 'camera'?");
}

}  // namespace
}  // namespace scanbed::scenarios
