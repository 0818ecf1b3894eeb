// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <regex>
#include <thread>

#include "tests/scenarios/run_program.hpp"

namespace scanbed::scenarios {
namespace {

using testing::Outcome;
using testing::run_program;
using testing::TemporaryFolder;

constexpr const char* kScenario = "static_hallway";

/// Features of each scan as the program prints them; without times where the format rounds those.
std::string features_of(const std::string& laser, bool with_times = true) {
  const Outcome outcome = run_program({"detect", "--laser", laser, "--limit", "20"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return with_times ? outcome.out : std::regex_replace(outcome.out, std::regex("\"t_s\":[^,]*,"), "");
}

class FidelityTest : public ::testing::TestWithParam<std::string> {};

// The same scenario and seed, in process, recorded and replayed: identical features, scan for scan.
TEST_P(FidelityTest, RecordedAndReplayedGivesTheSameFeatures) {
  const TemporaryFolder folder;
  const std::string file = (folder / ("x" + GetParam())).string();
  const Outcome recording =
      run_program({"detect", "--laser", std::string("sim:") + kScenario, "--limit", "20", "--record", file});
  ASSERT_EQ(recording.exit_code, 0) << recording.err;
  const bool keeps_times = GetParam() != ".player";
  EXPECT_EQ(
      features_of("log:" + file, keeps_times),
      keeps_times ? recording.out : std::regex_replace(recording.out, std::regex("\"t_s\":[^,]*,"), ""));
}

// Through our own format, which keeps everything, into another one.
TEST_P(FidelityTest, ConvertedGivesTheSameFeatures) {
  const TemporaryFolder folder;
  const std::string first = (folder / "a.jsonl").string();
  const std::string second = (folder / ("b" + GetParam())).string();
  ASSERT_EQ(
      run_program({"detect", "--laser", std::string("sim:") + kScenario, "--limit", "20", "--record", first})
          .exit_code,
      0);
  const Outcome converted = run_program({"convert", first, second});
  ASSERT_EQ(converted.exit_code, 0) << converted.err;
  EXPECT_NE(converted.err.find("20 scans"), std::string::npos) << converted.err;
  EXPECT_EQ(features_of("log:" + second, false), features_of("log:" + first, false));
}

INSTANTIATE_TEST_SUITE_P(Formats, FidelityTest,
                         ::testing::Values(".jsonl", ".jsonl.gz", ".mcap", ".bag", ".log", ".clf.gz",
                                           ".player"),
                         [](const auto& instance) {
                           std::string name = instance.param.substr(1);
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

// Truth goes along, so that a recorded run scores as the run did.
TEST(ConvertCommandTest, ARecordedRunScoresAsTheRunDid) {
  const TemporaryFolder folder;
  const std::string record = (folder / "x.mcap").string();
  const auto scores = [](const Outcome& outcome) {
    const std::size_t at = outcome.out.find("\"scores\"");
    EXPECT_NE(at, std::string::npos) << outcome.out << outcome.err;
    return outcome.out.substr(std::min(at, outcome.out.size()));
  };
  const Outcome run = run_program({"run", kScenario, "--json", "-", "--quiet", "--record", record});
  const Outcome replay =
      run_program({"run", kScenario, "--json", "-", "--quiet", "--laser", "log:" + record});
  EXPECT_EQ(scores(replay), scores(run));
}

TEST(ConvertCommandTest, OfACutOffRecordingWritesWhatThereIsAndSaysSo) {
  const TemporaryFolder folder;
  const std::string whole = (folder / "a.bag").string();
  ASSERT_EQ(run_program({"detect", "--laser", std::string("sim:") + kScenario, "--record", whole}).exit_code,
            0);
  std::filesystem::resize_file(whole, std::filesystem::file_size(whole) / 2);
  const std::string repaired = (folder / "b.bag").string();
  const Outcome outcome = run_program({"convert", whole, repaired});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("is not finished"), std::string::npos) << outcome.err;
  EXPECT_EQ(run_program({"detect", "--laser", "log:" + repaired}).exit_code, 0);
}

// Whatever is complete survives a kill that gives the program no chance.
TEST(ConvertCommandTest, ARecordingSurvivesAKill) {
  struct Case {
    const char* ending;
    std::uintmax_t num_bytes;  // by then three scans and more are on the disk
    bool has_end;              // the format tells a finished recording from a cut-off one
  };
  for (const auto& [ending, num_bytes, has_end] :
       {Case{".jsonl", 200'000, true}, Case{".jsonl.gz", 30'000, true}, Case{".mcap", 50'000, true},
        Case{".bag", 10'000, true}, Case{".log", 12'000, false}, Case{".log.gz", 5'000, true},
        Case{".player", 20'000, false}}) {
    const TemporaryFolder folder;
    const std::string source = (folder / "source.jsonl").string();
    ASSERT_EQ(
        run_program({"detect", "--laser", std::string("sim:") + kScenario, "--record", source}).exit_code, 0);
    const std::filesystem::path record = folder / (std::string("x") + ending);
    const std::filesystem::path part = record.string() + ".part";
    testing::Program program(
        {"detect", "--laser", "log:" + source + "?speed=20", "--record", record.string()});
    for (int i = 0; i < 500; ++i) {
      std::error_code error;
      const auto size = std::filesystem::file_size(part, error);
      if (!error && size > num_bytes) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    program.send(SIGKILL);
    program.wait();
    EXPECT_FALSE(std::filesystem::exists(record));
    const Outcome outcome = run_program({"detect", "--laser", "log:" + part.string()});
    EXPECT_EQ(outcome.exit_code, has_end ? 2 : 0) << ending << outcome.err;
    const bool is_told = outcome.err.find("not finished") != std::string::npos ||
                         outcome.err.find("cut off") != std::string::npos;
    EXPECT_EQ(is_told, has_end) << ending << outcome.err;
    EXPECT_NE(outcome.out.find("{\"scan\":2,"), std::string::npos) << ending;
  }
}

TEST(ConvertCommandTest, RefusesBadArguments) {
  const TemporaryFolder folder;
  const std::string log = testing::write_file(folder / "a.log", testing::flaser({"1.0", "2.0"})).string();
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"convert"},
           {"convert", log},
           {"convert", log, (folder / "b.txt").string()},
           {"convert", (folder / "no.log").string(), (folder / "b.bag").string()},
           {"convert", log + "?speed=x", (folder / "b.bag").string()},
           {"convert", log + "?from=100", (folder / "b.bag").string()}}) {
    EXPECT_EQ(run_program(arguments).exit_code, 2) << arguments.back();
  }
  EXPECT_EQ(run_program({"convert", log, "/nowhere/b.bag"}).exit_code, 3);
  EXPECT_FALSE(std::filesystem::exists(folder / "b.bag"));
}

TEST(ConvertCommandTest, ARecordedBagRunsThroughDetect) {
  const std::string bag = SCANBED_SOURCE_DIR "/../shared/data/legs_pos2.bag";
  if (!std::filesystem::exists(bag)) GTEST_SKIP() << "no recording at " << bag;
  const Outcome outcome = run_program({"detect", "--laser", "log:" + bag});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 83);
  EXPECT_NE(outcome.out.find("\"leg\""), std::string::npos);
}

}  // namespace
}  // namespace scanbed::scenarios
