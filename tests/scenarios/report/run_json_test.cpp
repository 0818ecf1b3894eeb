// SPDX-License-Identifier: MIT
#include "scenarios/report/run_json.hpp"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "tests/scenarios/made_result.hpp"

namespace scanbed::scenarios {
namespace {

nlohmann::json first_run(const RunResult& result) {
  const std::array<RunResult, 1> results = {result};
  return nlohmann::json::parse(run_json(results)).at("runs").at(0);
}

TEST(RunJsonTest, SaysWhatRan) {
  const nlohmann::json run = first_run(testing::made_result());
  EXPECT_EQ(run["scenario"], "hall");
  EXPECT_EQ(run["seed"], 7);
  EXPECT_EQ(run["engine"], "planar");
  EXPECT_EQ(run["scored_scans"], 10);
  EXPECT_EQ(run["laser"], "sim");
  EXPECT_EQ(run["preset"], "paper");
  EXPECT_EQ(run["scans"], 10);
  EXPECT_EQ(run["features"]["circle"], 16);
}

TEST(RunJsonTest, HoldsTheScores) {
  const nlohmann::json circle = first_run(testing::made_result())["scores"]["circle"];
  EXPECT_EQ(circle["truths"], 10);
  EXPECT_EQ(circle["found"], 8);
  EXPECT_DOUBLE_EQ(circle["recall"], 0.8);
  EXPECT_DOUBLE_EQ(circle["precision"], 0.5);
  EXPECT_DOUBLE_EQ(circle["false_per_scan"], 0.8);
  EXPECT_DOUBLE_EQ(circle["rms_error_m"], 0.03);
  EXPECT_DOUBLE_EQ(circle["bands"][1]["recall"], 0.75);
  EXPECT_TRUE(circle["bands"][0]["recall"].is_null());
  EXPECT_TRUE(circle["bands"][4]["to_m"].is_null());
}

TEST(RunJsonTest, HoldsTheGates) {
  const nlohmann::json run = first_run(testing::made_result());
  ASSERT_EQ(run["gates"].size(), 3u);
  EXPECT_DOUBLE_EQ(run["gates"][0]["at_least"], 0.75);
  EXPECT_EQ(run["gates"][0]["met"], true);
  EXPECT_TRUE(run["gates"][0]["known_fail"].is_null());
  EXPECT_TRUE(run["gates"][1]["value"].is_null());
  EXPECT_EQ(run["gates"][1]["met"], false);
  EXPECT_DOUBLE_EQ(run["gates"][2]["at_most"], 0.5);
  EXPECT_EQ(run["gates_met"], false);
}

TEST(RunJsonTest, HoldsCollisions) {
  RunResult result = testing::made_result();
  EXPECT_EQ(first_run(result)["collisions"], nlohmann::json::array());
  result.collisions = {{1.25, "robot", "column"}};
  EXPECT_EQ(first_run(result)["collisions"].dump(), R"([{"ids":["robot","column"],"time_s":1.25}])");
}

TEST(RunJsonTest, WritesNullForWhatWasNotMeasured) {
  RunResult result = testing::made_result();
  result.scores.reset();
  result.gates.clear();
  const nlohmann::json run = first_run(result);
  EXPECT_TRUE(run["scores"].is_null());
  EXPECT_TRUE(run["gates_met"].is_null());
  EXPECT_TRUE(run["known_fail"].is_null());
}

TEST(RunJsonTest, SurvivesNamesThatAreNoUtf8) {
  RunResult result = testing::made_result();
  result.laser = "log:\xff\"\n";
  EXPECT_EQ(first_run(result)["laser"], "log:\xef\xbf\xbd\"\n");
}

TEST(RunJsonTest, WritesTheSameBytesForTheSameResults) {
  const std::array<RunResult, 2> results = {testing::made_result(), testing::made_result()};
  EXPECT_EQ(run_json(results), run_json(results));
  EXPECT_EQ(nlohmann::json::parse(run_json(results)).at("runs").size(), 2u);
}

TEST(RunJsonTest, TellsExpectationsWindowsAndUnexpectedPasses) {
  RunResult result = testing::made_result();
  result.known_fail = "too hard";
  for (GateResult& gate : result.gates) gate.met = true;
  result.gates[0].need.window = {5.0, 12.0};
  result.expectations.push_back({.expectation = {.condition = {.at_least = 1}, .window = {1.0, 2.0}},
                                 .num_scans = 6,
                                 .num_held = 6,
                                 .first_missed_s = std::nullopt,
                                 .met = true});
  const auto run = nlohmann::json::parse(run_json(std::vector{result}))["runs"][0];
  EXPECT_EQ(run["gates"][0]["between_s"], nlohmann::json::parse("[5, 12]"));
  EXPECT_FALSE(run["gates"][1].contains("between_s"));
  EXPECT_EQ(run["expectations"][0]["held"], 6);
  EXPECT_EQ(run["expectations"][0]["scans"], 6);
  EXPECT_EQ(run["expectations"][0]["met"], true);
  EXPECT_EQ(run["expectations"][0]["between_s"], nlohmann::json::parse("[1, 2]"));
  EXPECT_EQ(run["unexpected_pass"], true);
  EXPECT_EQ(run["gates_met"], true);
}

TEST(RunJsonTest, HoldsWhatWasFollowed) {
  RunResult result = testing::made_result();
  EXPECT_TRUE(first_run(result)["scores"]["person"].is_null());
  result.scores->person =
      TrackTally{.num_truths = 10, .num_matches = 8, .num_switches = 1, .sum_error_m = 0.8};
  const nlohmann::json person = first_run(result)["scores"]["person"];
  EXPECT_EQ(person["truths"], 10);
  EXPECT_DOUBLE_EQ(person["mota"], 0.7);
  EXPECT_DOUBLE_EQ(person["motp_m"], 0.1);
  EXPECT_EQ(person["id_switches"], 1);
  EXPECT_EQ(person["false_per_scan"], 0.0);
  EXPECT_TRUE(person["id_switches_per_minute"].is_null()) << "nobody was in view for any time";
}

}  // namespace
}  // namespace scanbed::scenarios
