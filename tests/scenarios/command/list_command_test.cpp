// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/scenarios/run_program.hpp"
#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

using testing::Outcome;
using testing::run_program;

TEST(ListTest, ListsTheLibraryWithDescriptions) {
  const Outcome outcome = run_program({"list"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("static_hallway  "), std::string::npos);
  EXPECT_NE(outcome.out.find("dynamic_corridor  "), std::string::npos);
  EXPECT_EQ(outcome.err, "");
}

TEST(ListTest, ListsTheGoodOnesBesideABadOne) {
  const testing::TemporaryFolder folder;
  testing::write_file(folder / "bad.yaml", "schema: 1\nnmae: bad\n");
  testing::write_file(folder / "good.yaml", testing::kHead + "description: fine\n");
  ::setenv("SCANBED_LIBRARY", folder.path().c_str(), 1);
  const Outcome outcome = run_program({"list"});
  ::unsetenv("SCANBED_LIBRARY");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.out.find("good"), std::string::npos);
  EXPECT_NE(outcome.out.find("fine"), std::string::npos);
  EXPECT_NE(outcome.err.find("bad.yaml"), std::string::npos);
}

TEST(ListTest, CallsAFullDiskAFault) {
  EXPECT_EQ(run_program({"list"}, "/dev/full").exit_code, 3);
}

}  // namespace
}  // namespace scanbed::scenarios
