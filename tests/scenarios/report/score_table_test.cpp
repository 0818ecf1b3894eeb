// SPDX-License-Identifier: MIT
#include "scenarios/report/score_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <vector>

#include "tests/scenarios/made_result.hpp"

namespace scanbed::scenarios {
namespace {

using Words = std::vector<std::string>;

// The words of the first line that begins with these words; empty where there is none.
Words row(const std::string& table, const Words& first) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream stream(line);
    const Words words{std::istream_iterator<std::string>(stream), {}};
    if (words.size() >= first.size() && std::equal(first.begin(), first.end(), words.begin())) return words;
  }
  return {};
}

TEST(ScoreTableTest, BeginsWithWhatRan) {
  EXPECT_TRUE(score_table(testing::made_result())
                  .starts_with("hall  seed 7  laser sim  engine planar  preset paper  10 scans\n"));
}

TEST(ScoreTableTest, SaysWhatOfTheScansWasScored) {
  RunResult result = testing::made_result();
  result.num_scans = 12;
  EXPECT_NE(score_table(result).find("  12 scans, 10 of them scored: the others have no truth\n"),
            std::string::npos)
      << score_table(result);
}

TEST(ScoreTableTest, AMissedBarNeverLooksMet) {
  RunResult result = testing::made_result();
  result.gates = {
      {.need = {FeatureKind::kCircle, find_metric("precision", FeatureKind::kCircle).value(), 0.9945},
       .value = 0.994456763}};
  EXPECT_NE(score_table(result).find("0.99446  MISS"), std::string::npos) << score_table(result);
}

TEST(ScoreTableTest, CountsHaveAllTheirDigits) {
  RunResult result = testing::made_result();
  result.gates = {{.need = {FeatureKind::kLine, find_metric("truths", FeatureKind::kLine).value(), 2740},
                   .value = 21703,
                   .met = true}};
  EXPECT_NE(score_table(result).find("21703  pass"), std::string::npos) << score_table(result);
}

TEST(ScoreTableTest, HoldsARowForEachKind) {
  const std::string table = score_table(testing::made_result());
  EXPECT_EQ(row(table, {"circle", "10"}),
            (Words{"circle", "10", "8", "0.800", "16", "8", "0.500", "0.800", "30.0", "mm"}));
  EXPECT_EQ(row(table, {"line", "0"}), (Words{"line", "0", "0", "-", "0", "0", "-", "0.000", "-"}));
  EXPECT_EQ(row(table, {"leg", "0"}), (Words{"leg", "0", "0", "-", "1", "0", "0.000", "0.100", "-"}));
}

TEST(ScoreTableTest, HoldsRecallByRange) {
  EXPECT_EQ(row(score_table(testing::made_result()), {"circle", "-"}),
            (Words{"circle", "-", "0.750", "of", "4", "0.833", "of", "6", "-", "-"}));
}

TEST(ScoreTableTest, HoldsGatesAndVerdict) {
  const std::string table = score_table(testing::made_result());
  EXPECT_EQ(row(table, {"circle", "recall"}), (Words{"circle", "recall", ">=", "0.75", "0.8", "pass"}));
  EXPECT_EQ(row(table, {"line", "recall"}), (Words{"line", "recall", ">=", "0.9", "nothing", "MISS"}));
  EXPECT_EQ(row(table, {"leg", "fp_per_scan"}), (Words{"leg", "fp_per_scan", "<=", "0.5", "0.1", "pass"}));
  EXPECT_TRUE(table.ends_with("\nhall: 2 of 3 gates passed\n"));
}

TEST(ScoreTableTest, TellsAKnownFailure) {
  RunResult result = testing::made_result();
  result.known_fail = "columns too thin";
  EXPECT_TRUE(score_table(result).ends_with("2 of 3 gates passed; known failure: columns too thin\n"));
  result.gates.pop_back();
  result.gates.pop_back();
  EXPECT_TRUE(score_table(result).ends_with(
      "1 of 1 gates passed, although it is a known failure: columns too thin\n"));
}

TEST(ScoreTableTest, TellsTheReasonBesideAGateThatIsKnownToFail) {
  RunResult result = testing::made_result();
  result.gates[1].need.known_fail = "walls too far";
  EXPECT_EQ(
      row(score_table(result), {"line", "recall"}),
      (Words{"line", "recall", ">=", "0.9", "nothing", "miss", "known", "failure:", "walls", "too", "far"}));
}

TEST(ScoreTableTest, SaysThatNothingWasScoredWithoutTruth) {
  RunResult result = testing::made_result();
  result.scores.reset();
  result.gates.clear();
  const std::string table = score_table(result);
  EXPECT_NE(table.find("0 lines, 16 circles, 1 legs detected"), std::string::npos);
  EXPECT_NE(table.find("not scored"), std::string::npos);
}

TEST(ScoreTableTest, ShowsExpectationsAndWindows) {
  RunResult result = testing::made_result();
  result.gates[0].need.window = {5.0, 12.0};
  result.expectations.push_back({.expectation = {.condition = {.at_least = 1}, .window = {1.0, 2.0}},
                                 .num_scans = 6,
                                 .num_held = 5,
                                 .first_missed_s = 1.4,
                                 .met = false});
  const std::string table = score_table(result);
  EXPECT_NE(table.find("pass  5 to 12 s\n"), std::string::npos) << table;
  EXPECT_NE(
      table.find("  line, at least 1, in all scans of 1 to 2 s: held in 5 of 6  MISS  first at 1.4 s\n"),
      std::string::npos)
      << table;
  EXPECT_NE(table.find("0 of 1 expectations held"), std::string::npos) << table;
}

TEST(ScoreTableTest, ShowsExpectationsWithoutTruthToo) {
  RunResult result = testing::made_result();
  result.scores.reset();
  result.gates.clear();
  result.expectations.push_back({.expectation = {.condition = {.at_most = 3}},
                                 .num_scans = 10,
                                 .num_held = 10,
                                 .first_missed_s = std::nullopt,
                                 .met = true});
  EXPECT_NE(score_table(result).find("\nhall: 1 of 1 expectations held\n"), std::string::npos);
}

TEST(ScoreTableTest, ShowsWhatWasFollowed) {
  RunResult result = testing::made_result();
  EXPECT_EQ(score_table(result).find("MOTA"), std::string::npos);
  result.scores->person =
      TrackTally{.num_truths = 10, .num_matches = 8, .num_switches = 1, .sum_error_m = 0.8};
  const std::string table = score_table(result);
  EXPECT_NE(table.find("MOTA"), std::string::npos);
  EXPECT_NE(table.find("0.700"), std::string::npos);
  EXPECT_NE(table.find("100.0 mm"), std::string::npos);
}

}  // namespace
}  // namespace scanbed::scenarios
