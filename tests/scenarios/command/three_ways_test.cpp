// SPDX-License-Identifier: MIT
// The same scenario and seed in process, by way of emulator, port and driver, and recorded from there and
// replayed: the same features, scan for scan.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "tests/scenarios/run_program.hpp"

namespace scanbed::scenarios {
namespace {

using testing::Outcome;
using testing::Program;
using testing::run_program;

constexpr int kNumScans = 12;

/// Features of each scan, without its time: the wire's clock is not the simulation's.
std::vector<nlohmann::json> features_of(const Outcome& outcome) {
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  std::vector<nlohmann::json> features;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    features.push_back(nlohmann::json::parse(line)["features"]);
  }
  return features;
}

Outcome detect(const std::string& laser, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments = {"detect", "--laser", laser, "--limit", std::to_string(kNumScans)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(arguments);
}

class ThreeWaysTest : public ::testing::TestWithParam<const char*> {};

TEST_P(ThreeWaysTest, GiveTheSameFeatures) {
  const testing::TemporaryFolder folder;
  const std::string link = folder / "lms";
  const std::string record = folder / ("record" + std::string(GetParam()));
  Program emulator({"emulate", "dynamic_corridor", "--link", link, "--unpaced"});
  for (int i = 0; i < 1000 && !std::filesystem::exists(link); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  const Outcome wired = detect("sick:" + link + "?baud=500000&lossless=1", {"--record", record});
  emulator.send(SIGINT);
  emulator.wait();
  const Outcome direct = detect("sim:dynamic_corridor");
  const Outcome replayed = detect("log:" + record);
  const std::vector<nlohmann::json> expected = features_of(direct);
  ASSERT_EQ(expected.size(), static_cast<std::size_t>(kNumScans));
  EXPECT_FALSE(expected.back().empty());
  EXPECT_EQ(features_of(wired), expected);
  EXPECT_EQ(features_of(replayed), expected);
}

INSTANTIATE_TEST_SUITE_P(Formats, ThreeWaysTest,
                         ::testing::Values(".jsonl", ".jsonl.gz", ".mcap", ".bag", ".log", ".log.gz", ".clf",
                                           ".clf.gz", ".player", ".player.gz"),
                         [](const auto& instance) {
                           std::string name = std::string(instance.param).substr(1);
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

}  // namespace
}  // namespace scanbed::scenarios
