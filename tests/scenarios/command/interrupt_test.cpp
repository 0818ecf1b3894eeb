// SPDX-License-Identifier: MIT
#include "scenarios/command/interrupt.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <thread>

#include "tests/scenarios/run_program.hpp"
#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

TEST(InterruptTest, MarksTheFirstAndDiesOfTheSecond) {
  watch_signals();
  EXPECT_FALSE(is_interrupted());
  ::raise(SIGINT);
  EXPECT_TRUE(is_interrupted());
  EXPECT_EXIT(::raise(SIGINT), ::testing::KilledBySignal(SIGINT), "");
  watch_signals();
  EXPECT_FALSE(is_interrupted());
}

TEST(InterruptTest, EndsARunAfterTheScanInHandWithWhatWasDone) {
  const testing::TemporaryFolder folder;
  // A day in the world: far longer than the test waits.
  const std::string file =
      testing::write_file(folder / "long.yaml", "schema: 1\nname: long\nduration: 86400\n").string();
  testing::Program program({"run", file});
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  program.send(SIGINT);
  const testing::Outcome outcome = program.wait();
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_NE(outcome.out.find("(interrupted)"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace scanbed::scenarios
