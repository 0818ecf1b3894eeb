// SPDX-License-Identifier: MIT
#include "scenarios/report/run_summary.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/scenarios/made_result.hpp"

namespace scanbed::scenarios {
namespace {

// Circle: 10 truths, 8 found; its recall gate of 0.75 is met, line and leg see made_result().
RunResult result(const std::string& name, std::uint64_t seed) {
  RunResult result = testing::made_result();
  result.scenario = name;
  result.seed = seed;
  std::erase_if(result.gates, [](const GateResult& gate) { return !gate.met; });
  return result;
}

// Of runs that were not interrupted.
std::string summary(const std::vector<RunResult>& results) {
  return run_summary(results, static_cast<int>(results.size()));
}

bool holds_line(const std::string& text, const std::string& begin, const std::string& end) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(begin) != std::string::npos && line.ends_with(end)) return true;
  }
  return false;
}

TEST(RunSummaryTest, HasARowForEachScenario) {
  const std::vector<RunResult> results = {result("hall", 1), result("hall", 2), result("room", 1)};
  const std::string text = summary(results);
  EXPECT_TRUE(holds_line(text, "  hall                          2 ", "  pass")) << text;
  EXPECT_TRUE(holds_line(text, "  room                          1 ", "  pass")) << text;
  EXPECT_NE(text.find("0.800"), std::string::npos) << "recall of circles, 16 of 20: " << text;
  EXPECT_TRUE(text.ends_with("\n2 scenarios, 3 runs: no gate missed that is not known to fail\n")) << text;
}

// Pooled: 3 switches in 2 minutes, and 10 of 100 truths missed or taken for others.
TEST(RunSummaryTest, TellsHowPeopleWereFollowed) {
  std::vector<RunResult> results = {result("hall", 1), result("hall", 2)};
  results[0].scores->person = {
      .num_truths = 40, .num_matches = 40, .num_false = 2, .num_switches = 3, .object_time_s = 30.0};
  results[1].scores->person = {.num_truths = 60, .num_matches = 53, .object_time_s = 90.0};
  const std::string text = summary(results);
  EXPECT_TRUE(holds_line(text, "  scenario  ", "    MOTA  switches/min  false")) << text;
  EXPECT_TRUE(holds_line(text, "  hall  ", "   0.880          1.50   0.10  pass")) << text;
  EXPECT_TRUE(holds_line(summary({result("hall", 1)}), "  hall  ", "       -             -      -  pass"));
}

TEST(RunSummaryTest, TellsTheWorstOfAMissedGate) {
  std::vector<RunResult> results = {result("hall", 1), result("hall", 2), result("hall", 3)};
  for (const auto& [run, value] : {std::pair(1, 0.5), std::pair(2, 0.625)}) {
    results[run].gates[0].value = value;
    results[run].gates[0].met = false;
  }
  const std::string text = summary(results);
  EXPECT_TRUE(holds_line(text, "  hall  ", "MISS in 2 of 3")) << text;
  EXPECT_TRUE(holds_line(text, "hall: circle recall >= 0.75: missed in 2 of 3", "worst 0.5 (seed 2)"))
      << text;
  EXPECT_TRUE(text.ends_with("3 runs: 2 missed a gate\n")) << text;
}

// Whichever seed comes first.
TEST(RunSummaryTest, NothingMeasuredIsTheWorst) {
  for (const int empty : {0, 1}) {
    std::vector<RunResult> results = {result("hall", 1), result("hall", 2)};
    for (RunResult& run : results) run.gates[0].met = false;
    results[empty].gates[0].value.reset();
    const std::string worst = fmt::format("worst nothing (seed {})", empty + 1);
    EXPECT_TRUE(holds_line(summary(results), "missed in 2 of 2", worst)) << summary(results);
  }
}

TEST(RunSummaryTest, TellsWhyAKnownFailureFails) {
  std::vector<RunResult> results = {result("hall", 1), result("hall", 2)};
  results[0].gates[0].met = false;
  results[0].gates[0].need.known_fail = "too thin";
  results[1].gates[0].need.known_fail = "too thin";
  const std::string text = summary(results);
  EXPECT_TRUE(holds_line(text, "  hall  ", "known failure")) << text;
  EXPECT_TRUE(holds_line(text, "missed in 1 of 2", "known failure: too thin")) << text;
  EXPECT_NE(text.find("no gate missed that is not known"), std::string::npos);
}

TEST(RunSummaryTest, TellsWhoRanIntoWhom) {
  std::vector<RunResult> results = {result("hall", 1), result("hall", 2), result("room", 3)};
  EXPECT_EQ(summary(results).find("collisions"), std::string::npos);
  results[1].collisions = {{1.25, "robot", "post"}, {2.5, "ann", "ben"}};
  const std::string text = summary(results);
  EXPECT_NE(text.find("\n  hall: collisions in 1 of 2 runs; at 1.25 s robot runs into post (seed 2)\n"),
            std::string::npos)
      << text;
}

TEST(RunSummaryTest, LeavesOutRunsThatWereCutOffAndSaysSo) {
  std::vector<RunResult> results = {result("hall", 1), result("hall", 2), result("hall", 3)};
  results[2].interrupted = true;
  results[2].gates[0].met = false;
  const std::string text = run_summary(results, 400);
  EXPECT_TRUE(holds_line(text, "  hall                          2 ", "  pass")) << text;
  EXPECT_EQ(text.find("missed in"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("known to fail\nstopped after 2 of 400 runs\n")) << text;
  EXPECT_EQ(run_summary({}, 2), "no runs\nstopped after 0 of 2 runs\n");
}

TEST(RunSummaryTest, SurvivesRunsWithoutTruthAndNoRuns) {
  RunResult bare = result("hall", 1);
  bare.scores.reset();
  bare.gates.clear();
  EXPECT_TRUE(holds_line(summary({bare, result("hall", 2)}), "  hall  ", "pass"));
  EXPECT_EQ(summary({}), "no runs\n");
}

}  // namespace
}  // namespace scanbed::scenarios
