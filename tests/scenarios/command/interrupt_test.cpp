// SPDX-License-Identifier: MIT
#include "scenarios/command/interrupt.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

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

// In a process of its own, since the limit stays.
TEST(InterruptTest, ALimitOnFilesIsAnErrorOfTheWrite) {
  const testing::TemporaryFolder folder;
  const std::string file = (folder / "x").string();
  const auto write_too_much = [&] {
    watch_signals();
    const rlimit limit{10, 10};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT, 0600);
    const std::string text(10, 'x');
    const bool fits = ::write(descriptor, text.data(), text.size()) == 10;
    std::exit(fits && ::write(descriptor, text.data(), text.size()) < 0 && errno == EFBIG ? 0 : 1);
  };
  EXPECT_EXIT(write_too_much(), ::testing::ExitedWithCode(0), "");
}

/// What is left of a run that a signal meets in the middle of it: on a busy machine it takes longer to get
/// there, and where it had not begun nothing is printed.
testing::Outcome interrupted_run(int signal, const std::vector<std::string>& more = {}) {
  const testing::TemporaryFolder folder;
  // A day in the world: far longer than the test waits.
  const std::string file =
      testing::write_file(folder / "long.yaml", "schema: 1\nname: long\nduration: 86400\n").string();
  std::vector<std::string> arguments = {"run", file};
  arguments.insert(arguments.end(), more.begin(), more.end());
  testing::Outcome outcome;
  for (const int wait_ms : {300, 1000, 3000, 10000}) {
    testing::Program program(arguments);
    std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
    program.send(signal);
    outcome = program.wait();
    if (!outcome.out.empty()) break;
  }
  return outcome;
}

TEST(InterruptTest, SurvivesThatItIsToldToTerminateTwice) {
  watch_signals();
  ::raise(SIGTERM);
  ::raise(SIGTERM);
  EXPECT_EQ(interrupting_signal(), SIGTERM);
  watch_signals();
}

TEST(InterruptTest, AHangupThatIsIgnoredStaysSo) {
  ::signal(SIGHUP, SIG_IGN);
  watch_signals();
  ::raise(SIGHUP);
  EXPECT_FALSE(is_interrupted());
  ::signal(SIGHUP, SIG_DFL);
}

TEST(InterruptTest, EndsARunAfterTheScanInHandWithWhatWasDone) {
  for (const auto& [signal, exit_code] :
       {std::pair(SIGINT, 130), std::pair(SIGTERM, 143), std::pair(SIGHUP, 129)}) {
    const testing::Outcome outcome = interrupted_run(signal);
    EXPECT_EQ(outcome.exit_code, exit_code);
    EXPECT_NE(outcome.out.find("(interrupted)"), std::string::npos) << outcome.out;
  }
}

TEST(InterruptTest, LeavesRunsThatAreCutOffOutOfTheSummary) {
  const testing::Outcome outcome = interrupted_run(SIGINT, {"--seed", "1..3", "--jobs", "2"});
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.out, "no runs\nstopped after 0 of 3 runs\n");
}

TEST(InterruptTest, EndsWorkThatWaitsAtOnce) {
  using Clock = std::chrono::steady_clock;
  watch_signals();
  const auto start = Clock::now();
  work_until_interrupted([](const hw::StopSignal& stop) {
    ::raise(SIGTERM);
    stop.sleep(60.0);
  });
  EXPECT_EQ(interrupting_signal(), SIGTERM);
  watch_signals();
  work_until_interrupted([](const hw::StopSignal& stop) { stop.sleep(60.0); }, 0.05);
  EXPECT_LT(Clock::now() - start, std::chrono::seconds(30));
  EXPECT_FALSE(is_interrupted());
}

TEST(InterruptTest, TellsHowWorkFailed) {
  watch_signals();
  EXPECT_THROW(work_until_interrupted([](const hw::StopSignal&) { throw std::runtime_error("broken"); }),
               std::runtime_error);
}

}  // namespace
}  // namespace scanbed::scenarios
