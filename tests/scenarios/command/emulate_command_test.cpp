// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "tests/scenarios/run_program.hpp"

namespace scanbed::scenarios {
namespace {

using testing::Outcome;
using testing::Program;
using testing::run_program;

/// An emulator in a scenario, up and running.
class EmulateTest : public ::testing::Test {
 protected:
  std::unique_ptr<Program> start(std::vector<std::string> more,
                                 const std::string& scenario = "static_hallway") {
    std::vector<std::string> arguments = {"emulate", scenario, "--link", link(), "--unpaced"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    auto program = std::make_unique<Program>(arguments);
    for (int i = 0; i < 500 && !std::filesystem::exists(link()); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return program;
  }
  std::string link() const { return folder_ / "lms"; }
  std::string laser() const { return "sick:" + link() + "?baud=500000&lossless=1"; }

  testing::TemporaryFolder folder_;
};

TEST_F(EmulateTest, DetectReadsTheEmulatedSensorAsItReadsTheSimulatedOne) {
  const auto emulator = start({});
  const Outcome wired = run_program({"detect", "--laser", laser(), "--limit", "20"});
  EXPECT_EQ(wired.exit_code, 0) << wired.err;
  const Outcome direct = run_program({"detect", "--laser", "sim:static_hallway", "--limit", "20"});
  std::istringstream wired_lines(wired.out);
  std::istringstream direct_lines(direct.out);
  std::string a;
  std::string b;
  int num_lines = 0;
  while (std::getline(wired_lines, a) && std::getline(direct_lines, b)) {
    EXPECT_EQ(nlohmann::json::parse(a)["features"], nlohmann::json::parse(b)["features"])
        << "scan " << num_lines;
    ++num_lines;
  }
  EXPECT_EQ(num_lines, 20);
  emulator->send(SIGINT);
  const Outcome outcome = emulator->wait();
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.out, link() + "\n");
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(link())));
}

TEST_F(EmulateTest, RunScoresTheWireAsItScoresTheSimulation) {
  const std::string truth = folder_ / "truth.jsonl";
  // Follows nothing: what is followed depends on the clock, and this one does not keep to it.
  const std::string scenario = "dark_and_glass";
  const auto emulator = start({"--truth", truth}, scenario);
  const Outcome wired = run_program({"run", scenario, "--laser", laser(), "--truth", truth, "--json", "-"});
  const Outcome direct = run_program({"run", scenario, "--json", "-"});
  emulator->send(SIGINT);
  emulator->wait();
  ASSERT_FALSE(wired.out.empty()) << wired.err;
  auto a = nlohmann::json::parse(wired.out);
  auto b = nlohmann::json::parse(direct.out);
  for (auto* results : {&a, &b}) {
    if (results->contains("runs")) {
      for (auto& run : (*results)["runs"]) {
        for (const char* of_laser : {"laser", "engine", "seed"}) run.erase(of_laser);
      }
    }
    results->erase("laser");
  }
  EXPECT_EQ(a, b);
  EXPECT_EQ(wired.exit_code, direct.exit_code);
}

TEST_F(EmulateTest, EndsAfterTheTimeGiven) {
  const Outcome outcome = run_program({"emulate", "static_hallway", "--for", "0.1"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(outcome.out.starts_with("/dev/pts/")) << outcome.out;
}

TEST_F(EmulateTest, FaultsOfFilesEndItWithTheirReason) {
  const Outcome no_truth = run_program({"emulate", "static_hallway", "--truth", "/no/such/file"});
  EXPECT_EQ(no_truth.exit_code, 3);
  EXPECT_EQ(no_truth.err,
            "scanbed: error: --truth /no/such/file: cannot be written: No such file or directory\n");
  const Outcome no_link = run_program({"emulate", "static_hallway", "--link", "/no/such/folder/lms"});
  EXPECT_EQ(no_link.exit_code, 3);
  EXPECT_EQ(no_link.err,
            "scanbed: error: /no/such/folder/lms: cannot make the link: No such file or directory\n");
}

TEST_F(EmulateTest, EndsWhereItsTruthIsLost) {
  const auto emulator = start({"--truth", "/dev/full"});
  Program host({"detect", "--laser", laser()});
  const Outcome outcome = emulator->wait();
  host.send(SIGINT);
  host.wait();
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("--truth /dev/full: cannot be written: No space left"), std::string::npos)
      << outcome.err;
}

TEST_F(EmulateTest, RefusesTheNameOfAnotherThatRuns) {
  const auto first = start({});
  const std::string truth = testing::write_file(folder_ / "truth", "of the first");
  const Outcome second = run_program({"emulate", "static_hallway", "--link", link(), "--truth", truth});
  EXPECT_EQ(second.exit_code, 3);
  EXPECT_EQ(std::filesystem::file_size(truth), 12u);
  EXPECT_NE(second.err.find("another emulator"), std::string::npos) << second.err;
  EXPECT_TRUE(std::filesystem::exists(link()));
  // Held open, so that no other program gets a terminal of the same name meanwhile.
  const int terminal = ::open(link().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_GE(terminal, 0);
  first->send(SIGKILL);
  first->wait();
  EXPECT_EQ(run_program({"emulate", "static_hallway", "--link", link(), "--for", "0.1"}).exit_code, 0);
  ::close(terminal);
}

TEST_F(EmulateTest, RefusesBadInputInOneLine) {
  const auto refused = [](const std::vector<std::string>& arguments) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    return outcome.err;
  };
  EXPECT_NE(refused({"emulate", "static_hallway", "--fault", "fire@1"}).find("unknown name"),
            std::string::npos);
  EXPECT_NE(refused({"emulate", "static_hallway", "--baud", "5000000"})
                .find("--baud: value 5000000 is out of range; allowed: 9600, 19200, 38400, 500000"),
            std::string::npos);
  EXPECT_NE(refused({"emulate", "static_hallway", "--address", "200"}).find("--address"), std::string::npos);
  EXPECT_NE(refused({"emulate", "static_hallway", "--for", "-1"}).find("--for"), std::string::npos);
  const std::string file = testing::write_file(folder_ / "precious", "x");
  EXPECT_NE(refused({"emulate", "static_hallway", "--link", file}).find("no symbolic link"),
            std::string::npos);
  EXPECT_NE(refused({"run", "static_hallway", "--truth", file}).find("--truth"), std::string::npos);
  EXPECT_NE(refused({"emulate", "static_hallway", "--truth", "-"}).find("name a file"), std::string::npos);
  EXPECT_NE(refused({"emulate", "static_hallway", "--set", "sensor.pitch_deg=20"}).find("--backend spatial"),
            std::string::npos);
}

TEST_F(EmulateTest, TakesATiltedLaserInTheSpatialEngine) {
  const Outcome outcome = run_program(
      {"emulate", "static_hallway", "--set", "sensor.pitch_deg=20", "--backend", "spatial", "--for", "0.1"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST_F(EmulateTest, ATruthOfOtherScansIsNone) {
  const std::string truth = folder_ / "truth";
  const std::string other = testing::write_file(folder_ / "other", "");
  const auto emulator = start({"--truth", truth}, "v_corners");
  const Outcome outcome =
      run_program({"run", "v_corners", "--set", "duration=1", "--laser", laser(), "--truth", other});
  EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
  EXPECT_NE(outcome.err.find("other: is of none of the "), std::string::npos) << outcome.err;
  emulator->send(SIGINT);
  emulator->wait();
}

}  // namespace
}  // namespace scanbed::scenarios
