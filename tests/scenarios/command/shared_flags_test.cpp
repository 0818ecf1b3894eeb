// SPDX-License-Identifier: MIT
#include "scenarios/command/shared_flags.hpp"

#include <gtest/gtest.h>

#include "core/detect/table_two.hpp"
#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

using testing::error_of;

TEST(SharedFlagsTest, AnUnsaidSeedIsNone) {
  EXPECT_EQ(SeedFlag{}.value(), std::nullopt);
  EXPECT_EQ(SeedFlag{"7"}.value(), 7u);
  EXPECT_EQ(error_of([] { SeedFlag{"x"}.value(); }), "--seed: expected a whole number, found 'x'");
}

TEST(SharedFlagsTest, AFlagWritesIntoItsOwnersText) {
  SettingFlag settings;
  std::get<std::vector<std::string>*>(settings.flag().text)->push_back("vars.R=0.3");
  ASSERT_EQ(settings.values().size(), 1u);
  EXPECT_EQ(settings.values()[0].path, "vars.R");
  EXPECT_EQ(settings.values()[0].value, "0.3");
}

TEST(SharedFlagsTest, EnginesHaveNames) {
  EXPECT_EQ(BackendFlag{}.value(), sim::Backend::kPlanar);
  EXPECT_EQ(BackendFlag{"spatial"}.value(), sim::Backend::kSpatial);
  EXPECT_EQ(error_of([] { BackendFlag{"spacial"}.value(); }),
            "--backend: unknown value 'spacial'; did you mean 'spatial'?");
}

TEST(SharedFlagsTest, TheHelpNamesAllOfTableTwo) {
  const std::string text = table_two_text();
  for (const TableTwoEntry& entry : table_two()) {
    EXPECT_NE(text.find(std::string(entry.name)), std::string::npos) << entry.name;
  }
}

}  // namespace
}  // namespace scanbed::scenarios
