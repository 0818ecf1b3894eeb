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

TEST(SharedFlagsTest, SeedsAreOneOrARange) {
  EXPECT_FALSE(SeedsFlag{}.value());
  EXPECT_EQ(SeedsFlag{"7"}.value()->first, 7u);
  EXPECT_EQ(SeedsFlag{"7"}.value()->count(), 1);
  EXPECT_EQ(SeedsFlag{"3..12"}.value()->first, 3u);
  EXPECT_EQ(SeedsFlag{"3..12"}.value()->count(), 10);
  EXPECT_EQ(error_of([] { SeedsFlag{"3..x"}.value(); }), "--seed: expected a whole number, found 'x'");
  EXPECT_EQ(error_of([] { SeedsFlag{"3..2"}.value(); }), "--seed: '3..2': ends before it begins");
  EXPECT_EQ(error_of([] { SeedsFlag{"1..900000"}.value(); }),
            "--seed: '1..900000': too many; allowed: 100000 seeds");
}

TEST(SharedFlagsTest, JobsAreAtLeastOne) {
  EXPECT_GE(JobsFlag{}.value(), 1);
  EXPECT_EQ(JobsFlag{"3"}.value(), 3);
  EXPECT_NE(error_of([] { JobsFlag{"0"}.value(); }), "");
  EXPECT_NE(error_of([] { JobsFlag{"1000"}.value(); }), "");
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
