// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/scenarios/run_program.hpp"
#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

using testing::Outcome;
using testing::run_program;

TEST(ValidateTest, SaysThatGoodFilesAreGood) {
  const testing::TemporaryFolder folder;
  const std::string file = testing::write_file(folder / "a.yaml", testing::kHead).string();
  const Outcome outcome = run_program({"validate", file, "static_hallway"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, file + ": ok, test\nstatic_hallway: ok, static_hallway\n");
}

TEST(ValidateTest, TellsOfEveryBadFile) {
  const testing::TemporaryFolder folder;
  const std::string bad = testing::write_file(folder / "bad.yaml", testing::kHead + "sede: 1\n").string();
  const Outcome outcome = run_program({"validate", bad, "static_hallway", "/nowhere.yaml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "static_hallway: ok, static_hallway\n");
  EXPECT_EQ(outcome.err, "scanbed: error: " + bad + ":4:1: unknown key 'sede'; did you mean 'seed'?\n" +
                             "scanbed: error: /nowhere.yaml: no such file\n");
}

}  // namespace
}  // namespace scanbed::scenarios
