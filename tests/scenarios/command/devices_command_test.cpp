// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/scenarios/run_program.hpp"
#include "tests/support/running_emulator.hpp"

namespace scanbed::scenarios {
namespace {

using testing::Outcome;
using testing::run_program;

TEST(DevicesTest, ListsWithoutFail) {
  EXPECT_EQ(run_program({"devices"}).exit_code, 0);
}

TEST(DevicesTest, TellsWhatIsAtAPort) {
  tests::RunningEmulator emulator(tests::quick_sensor());
  const Outcome outcome = run_program({"devices", "--probe", emulator.port()});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, emulator.port() + ": LMS200;301063;V02.10  at 9600 baud, 180 degrees at 0.5, mm\n");
}

TEST(DevicesTest, TellsWhyAPortCannotBeAsked) {
  const Outcome outcome = run_program({"devices", "--probe", "/dev/no_such_port"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.out.starts_with("/dev/no_such_port: no such port")) << outcome.out;
}

}  // namespace
}  // namespace scanbed::scenarios
