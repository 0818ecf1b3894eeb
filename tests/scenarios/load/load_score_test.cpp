// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/geometry/angles.hpp"
#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

using testing::parse;
using testing::parse_error;

TEST(LoadScoreTest, ReadsWhenADetectionIsRight) {
  const MatchOptions match =
      parse(
          "score:\n  line: {gate: {angle_deg: 5, offset: 0.1, overlap: 0.7}}\n"
          "  circle: {gate: {center: 0.2, radius: 0.1}}\n  leg: {gate: {center: 0.3}}\n")
          .match;
  EXPECT_DOUBLE_EQ(match.line_angle_rad, radians(5.0));
  EXPECT_EQ(match.line_offset_m, 0.1);
  EXPECT_EQ(match.line_overlap_ratio, 0.7);
  EXPECT_EQ(match.circle_center_m, 0.2);
  EXPECT_EQ(match.circle_radius_m, 0.1);
  EXPECT_EQ(match.leg_center_m, 0.3);
}

TEST(LoadScoreTest, ReadsNeedsInTheirOrder) {
  const Scenario scenario =
      parse("score: {circle: {need: {recall: 0.8, precision: 0.9}}, leg: {need: {fp_per_scan: 2}}}\n");
  ASSERT_EQ(scenario.needs.size(), 3u);
  EXPECT_EQ(scenario.needs[0].kind, FeatureKind::kCircle);
  EXPECT_EQ(scenario.needs[0].metric.name, "recall");
  EXPECT_EQ(scenario.needs[0].bound, 0.8);
  EXPECT_EQ(scenario.needs[1].metric.name, "precision");
  EXPECT_EQ(scenario.needs[2].kind, FeatureKind::kLeg);
  EXPECT_EQ(scenario.needs[2].bound, 2.0);
}

TEST(LoadScoreTest, ReadsNeedsOfWhatIsFollowed) {
  const Scenario scenario = parse(
      "score: {person: {gate: {center: 0.3}, need: {mota: 0.9, id_switches_per_minute: 1}}, "
      "cylinder: {gate: {center: 0.4}, need: {idf1: 0.95, motp: 0.1, truths: 5}}}\n");
  EXPECT_EQ(scenario.match.person_m, 0.3);
  EXPECT_EQ(scenario.match.cylinder_m, 0.4);
  ASSERT_EQ(scenario.needs.size(), 5u);
  EXPECT_EQ(scenario.needs[0].kind, FeatureKind::kPerson);
  EXPECT_EQ(scenario.needs[0].metric.measure, Measure::kMota);
  EXPECT_FALSE(scenario.needs[0].metric.at_most);
  EXPECT_EQ(scenario.needs[1].metric.measure, Measure::kSwitchesPerMinute);
  EXPECT_TRUE(scenario.needs[1].metric.at_most);
  EXPECT_EQ(scenario.needs[2].kind, FeatureKind::kCylinder);
}

// A bar that asks for nothing would be a gate that is not there.
TEST(LoadScoreTest, RefusesBarsThatAskForNothing) {
  for (const char* bar : {"circle: {}", "circle: {need: {}}", "circle: {need: []}",
                          "circle: {need: [{preset: paper}]}", "circle: {need: [{recall: 0.9}, {}]}"}) {
    EXPECT_NE(parse_error("score: {" + std::string(bar) + "}\n").find("asks for nothing"), std::string::npos)
        << bar;
  }
  EXPECT_TRUE(parse("score: {circle: {gate: {center: 0.2}}}\n").needs.empty());
}

TEST(LoadScoreTest, FeaturesAndTracksHaveTheirOwnMetrics) {
  EXPECT_NE(parse_error("score: {circle: {need: {mota: 0.9}}}\n").find("unknown key 'mota'"),
            std::string::npos);
  EXPECT_NE(parse_error("score: {person: {need: {recall: 0.9}}}\n").find("unknown key 'recall'"),
            std::string::npos);
}

TEST(LoadScoreTest, RefusesUnknownKindsMetricsAndGates) {
  EXPECT_EQ(parse_error("score: {circel: {}}\n"), "f:4:9: unknown key 'circel'; did you mean 'circle'?");
  EXPECT_EQ(parse_error("score: {leg: {need: {recal: 0.9}}}\n"),
            "f:4:22: unknown key 'recal'; did you mean 'recall'?");
  EXPECT_EQ(parse_error("score: {leg: {gate: {radius: 0.1}}}\n"),
            "f:4:22: unknown key 'radius'; known keys: center");
  EXPECT_EQ(parse_error("score: {leg: {needs: {}}}\n"), "f:4:15: unknown key 'needs'; did you mean 'need'?");
}

TEST(LoadScoreTest, RefusesBoundsThatNothingCanMeet) {
  EXPECT_EQ(parse_error("score: {leg: {need: {recall: 1.1}}}\n"),
            "f:4:30: recall: value 1.1 is out of range; allowed: [0, 1]");
  EXPECT_EQ(parse_error("score: {leg: {need: {fp_per_scan: -1}}}\n"),
            "f:4:35: fp_per_scan: value -1 is out of range; allowed: >= 0");
  EXPECT_EQ(parse_error("score: {leg: {gate: {center: 0}}}\n"),
            "f:4:30: center: value 0 is out of range; allowed: (0, 10]");
}

TEST(LoadScoreTest, TakesNeedsOfSeveralWindows) {
  const Scenario scenario = testing::parse(
      "score: {circle: {need: [{recall: 0.9}, {between: [0.5, 1], recall: 0.5, truths: 3}]}}\n");
  ASSERT_EQ(scenario.needs.size(), 3u);
  EXPECT_TRUE(scenario.needs[0].window.is_whole());
  EXPECT_EQ(scenario.needs[1].window, (TimeWindow{0.5, 1.0}));
  EXPECT_EQ(scenario.needs[2].window, (TimeWindow{0.5, 1.0}));
  EXPECT_EQ(testing::parse_error("score: {circle: {need: {between: [1, 0], recall: 1}}}\n"),
            "f:4:38: between: the window ends before it begins");
}

TEST(LoadScoreTest, TakesNeedsOfOnePresetAndKnownFailures) {
  const Scenario scenario = testing::parse(
      "score: {circle: {need: [{preset: robust, recall: 0.9}, {known_fail: too thin, recall: 1}]}}\n");
  ASSERT_EQ(scenario.needs.size(), 2u);
  EXPECT_EQ(scenario.needs[0].preset, "robust");
  EXPECT_EQ(scenario.needs[0].known_fail, std::nullopt);
  EXPECT_EQ(scenario.needs[1].preset, std::nullopt);
  EXPECT_EQ(scenario.needs[1].known_fail, "too thin");
  EXPECT_EQ(testing::parse_error("score: {circle: {need: {preset: papre, recall: 1}}}\n"),
            "f:4:33: preset: unknown value 'papre'; did you mean 'paper'?");
}

}  // namespace
}  // namespace scanbed::scenarios
