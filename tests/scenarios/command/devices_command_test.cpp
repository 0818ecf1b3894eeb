// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include "hw/serial/pseudo_terminal.hpp"
#include "tests/scenarios/run_program.hpp"
#include "tests/support/running_emulator.hpp"

namespace scanbed::scenarios {
namespace {

using testing::Outcome;
using testing::Program;
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

TEST(DevicesTest, TellsWhyAPortIsNoneAndGoesOn) {
  const hw::PseudoTerminal port({});
  for (const std::vector<std::string>& flags : {std::vector<std::string>{}, {"--probe"}}) {
    std::vector<std::string> arguments = {"devices", "/dev/no_such_port", "/dev/null", port.path()};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(
        outcome.err,
        "scanbed: error: /dev/no_such_port: no such port; is it plugged in? `scanbed devices` lists the "
        "ports\n"
        "scanbed: error: /dev/null: not a serial port; `scanbed devices` lists the ports\n");
    EXPECT_EQ(outcome.out, port.path() + (flags.empty() ? "\n" : ": no LMS answers\n"));
  }
}

TEST(DevicesTest, StopsAskingWhenInterrupted) {
  hw::PseudoTerminal noisy({});
  Program program({"devices", "--probe", noisy.path()});
  const hw::Bytes noise(64, 0x02);
  for (int i = 0; i < 50; ++i) {
    noisy.write(noise);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  program.send(SIGINT);
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.out, "");
}

}  // namespace
}  // namespace scanbed::scenarios
