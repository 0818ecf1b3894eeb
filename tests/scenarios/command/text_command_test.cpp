// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/scenarios/run_program.hpp"

namespace scanbed::scenarios {
namespace {

TEST(TextTest, GoesToStandardOutput) {
  const testing::Outcome version = testing::run_program({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.out, "scanbed " SCANBED_TEST_VERSION "\n");
  EXPECT_EQ(version.err, "");
  const testing::Outcome help = testing::run_program({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.out.find("Examples:"), std::string::npos);
}

TEST(TextTest, CallsAFullDiskAFault) {
  EXPECT_EQ(testing::run_program({"--help"}, "/dev/full").exit_code, 3);
}

}  // namespace
}  // namespace scanbed::scenarios
