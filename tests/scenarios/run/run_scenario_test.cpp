// SPDX-License-Identifier: MIT
#include "scenarios/run/run_scenario.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

// Gives the same scan again and again: a cylinder of 0.3 m radius, 2 m ahead, in closed form.
class OneCylinder final : public RangeSensor {
 public:
  OneCylinder(int num_scans, bool knows_truth) : num_left_(num_scans), knows_truth_(knows_truth) {
    ObjectTruth cylinder{.id = "c", .label = "column", .primitive = Primitive::kCircle};
    cylinder.center_m = {2.0, 0.0};
    cylinder.radius_m = 0.3;
    truth_.objects.push_back(cylinder);
    scan_.geometry = geometry_;
    for (int beam = 0; beam < geometry_.num_beams; ++beam) add(beam);
    truth_.objects[0].visibility = Visibility::kResolvable;
  }

  const ScanGeometry& geometry() const override { return geometry_; }
  const Truth* truth() const override { return knows_truth_ ? &truth_ : nullptr; }
  bool next(LaserScan& scan, Seconds) override {
    if (num_left_-- <= 0) return false;
    scan = scan_;
    return true;
  }

 private:
  // |r u - c|^2 = R^2 with c = (2, 0).
  void add(int beam) {
    const double along_m = 2.0 * std::cos(geometry_.bearing_rad(beam));
    const double root = along_m * along_m - (4.0 - 0.09);
    BeamTruth truth;
    truth.range_m = root < 0.0 || along_m < 0.0 ? kNoEcho : along_m - std::sqrt(root);
    if (std::isfinite(truth.range_m)) {
      truth.object = 0;
      ++truth_.objects[0].num_clean_beams;
    }
    truth_.beams.push_back(truth);
    scan_.range_m.push_back(truth.range_m);
  }

  ScanGeometry geometry_;
  LaserScan scan_;
  Truth truth_;
  int num_left_;
  bool knows_truth_;
};

RunResult run(RangeSensor& sensor, int stop_after = 1000) {
  const Scenario scenario = testing::parse("seed: 5\nscore: {circle: {need: {recall: 1, precision: 1}}}\n");
  FeatureDetector detector{paper_options()};
  return run_scenario(scenario, sensor, {detector},
                      [&](const LaserScan&, const Features&) { return --stop_after > 0; });
}

TEST(RunScenarioTest, ScoresEveryScan) {
  OneCylinder sensor(4, true);
  const RunResult result = run(sensor);
  EXPECT_EQ(result.scenario, "test");
  EXPECT_EQ(result.num_scans, 4);
  EXPECT_EQ(result.features.circles, 4);
  ASSERT_TRUE(result.scores.has_value());
  EXPECT_EQ(result.scores->circle.tally.num_truths, 4);
  EXPECT_EQ(result.scores->circle.tally.num_found, 4);
  EXPECT_EQ(result.gates.size(), 2u);
  EXPECT_TRUE(result.met_its_gates());
  EXPECT_FALSE(result.interrupted);
}

TEST(RunScenarioTest, CountsButDoesNotScoreWithoutTruth) {
  OneCylinder sensor(3, false);
  const RunResult result = run(sensor);
  EXPECT_EQ(result.num_scans, 3);
  EXPECT_EQ(result.features.circles, 3);
  EXPECT_FALSE(result.scores.has_value());
  EXPECT_TRUE(result.gates.empty());
}

TEST(RunScenarioTest, StopsWhenTheObserverSaysSo) {
  OneCylinder sensor(10, true);
  const RunResult result = run(sensor, 2);
  EXPECT_EQ(result.num_scans, 2);
  EXPECT_TRUE(result.interrupted);
}

TEST(RunScenarioTest, ScoresNothingOfAnEmptyStream) {
  OneCylinder sensor(0, true);
  const RunResult result = run(sensor);
  EXPECT_EQ(result.num_scans, 0);
  EXPECT_FALSE(result.scores.has_value());
}

TEST(RunScenarioTest, MissesItsGatesWhereOneIsMissed) {
  RunResult result;
  EXPECT_TRUE(result.met_its_gates());
  result.gates = {{.need = {}, .value = 1.0, .met = true}, {.need = {}, .value = 0.0, .met = false}};
  EXPECT_FALSE(result.met_its_gates());
}

TEST(RunScenarioTest, MissesItsGatesWhereAnExpectationIsMissed) {
  RunResult result;
  result.expectations.push_back({.expectation = {}, .first_missed_s = std::nullopt, .met = true});
  EXPECT_TRUE(result.met_its_gates());
  result.expectations.push_back({.expectation = {}, .first_missed_s = 1.0, .met = false});
  EXPECT_FALSE(result.met_its_gates());
}

TEST(RunScenarioTest, PassesUnexpectedlyOnlyWhereSomethingWasMeasured) {
  RunResult result;
  result.known_fail = "too hard";
  EXPECT_FALSE(result.passed_unexpectedly());
  result.gates = {{.need = {}, .value = 1.0, .met = true}};
  EXPECT_TRUE(result.passed_unexpectedly());
  result.interrupted = true;
  EXPECT_FALSE(result.passed_unexpectedly());
  result.interrupted = false;
  result.gates[0].met = false;
  EXPECT_FALSE(result.passed_unexpectedly());
}

TEST(RunScenarioTest, AcceptsMissesThatAreKnown) {
  RunResult result;
  EXPECT_TRUE(result.is_accepted());
  result.gates = {{.need = {.known_fail = "too hard"}, .value = 0.0, .met = false}};
  result.expectations.push_back({.expectation = {.known_fail = "too hard"}, .first_missed_s = 0.0});
  EXPECT_TRUE(result.is_accepted());
  EXPECT_FALSE(result.met_its_gates());
  result.gates.push_back({.need = {}, .value = 0.0, .met = false});
  EXPECT_FALSE(result.is_accepted());
  result.known_fail = "all too hard";
  EXPECT_TRUE(result.is_accepted());
}

TEST(RunScenarioTest, FollowsWhereAskedOrNeeded) {
  const Scenario plain = testing::parse("seed: 5\n");
  const Scenario needs = testing::parse("seed: 5\nscore: {cylinder: {need: {truths: 3}}}\n");
  FeatureDetector detector{robust_options()};
  const auto go_on = [](const LaserScan&, const Features&) { return true; };
  OneCylinder first(5, true);
  EXPECT_FALSE(run_scenario(plain, first, {detector}, go_on).scores->cylinder);
  OneCylinder second(5, true);
  const RunResult asked = run_scenario(plain, second, {detector, {.track = true}}, go_on);
  ASSERT_TRUE(asked.scores->cylinder);
  EXPECT_EQ(asked.scores->cylinder->num_truths, 5);
  EXPECT_EQ(asked.scores->cylinder->num_matches, 4);  // one hit confirms nothing
  OneCylinder third(5, true);
  EXPECT_TRUE(run_scenario(needs, third, {detector}, go_on).met_its_gates());
}

TEST(RunScenarioTest, InterpretsWhereAScenarioExpectsSomethingOfTheScene) {
  const Scenario scenario =
      testing::parse("expect: [{column: {at_least: 1}, scans: some}, {bench: {at_most: 0}}]\n");
  FeatureDetector detector{robust_options()};
  OneCylinder sensor(5, true);
  const auto go_on = [](const LaserScan&, const Features&) { return true; };
  const RunResult result = run_scenario(scenario, sensor, {detector}, go_on);
  ASSERT_EQ(result.expectations.size(), 2u);
  for (const ExpectResult& expectation : result.expectations) {
    EXPECT_EQ(expectation.num_scans, 5);
    EXPECT_TRUE(expectation.met) << expectation.expectation.text();
  }
}

}  // namespace
}  // namespace scanbed::scenarios
