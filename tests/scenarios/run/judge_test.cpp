// SPDX-License-Identifier: MIT
#include "scenarios/run/judge.hpp"

#include <gtest/gtest.h>

#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

// Ten scans at 0, 1, ... 9 s of one column, which is found in those that `found` says.
class JudgeTest : public ::testing::Test {
 protected:
  void watch(const std::string& rest, const std::vector<int>& found, bool has_truth = true) {
    scenario_ = parse_scenario(
        "schema: 1\nname: j\nduration: 10\nworld: [{id: col, cylinder: {at: [3, 0], r: 0.25}}]\n" + rest,
        "f");
    Judge judge(scenario_, "robust");
    ObjectTruth column;
    column.id = "col";
    column.primitive = Primitive::kCircle;
    column.center_m = {3.0, 0.0};
    column.radius_m = 0.25;
    column.visibility = Visibility::kResolvable;
    Truth truth;
    truth.objects = {column};
    for (int i = 0; i < 10; ++i) {
      LaserScan scan;
      scan.time_s = i;
      Features features;
      if (std::find(found.begin(), found.end(), i) != found.end()) {
        features.circles.push_back({.center_m = column.center_m, .radius_m = 0.25});
      }
      judge.add({scan, features, has_truth ? &truth : nullptr});
    }
    gates_ = judge.gates();
    results_ = judge.expectations();
  }

  Scenario scenario_;
  std::vector<GateResult> gates_;
  std::vector<ExpectResult> results_;
};

TEST_F(JudgeTest, CountsTheScansOfTheWindowAlone) {
  watch("expect: [{between: [2, 5], circle: {near: col, within: 0.1}}]\n", {2, 3, 4, 5});
  EXPECT_EQ(results_.at(0).num_scans, 4);
  EXPECT_EQ(results_.at(0).num_held, 4);
  EXPECT_TRUE(results_.at(0).met);
  watch("expect: [{between: [2, 5], circle: {near: col, within: 0.1}}]\n", {0, 1, 2, 3, 5, 6, 7, 8, 9});
  EXPECT_FALSE(results_.at(0).met);
  EXPECT_EQ(results_.at(0).first_missed_s, 4.0);
}

TEST_F(JudgeTest, AsksForAShareOrForOneScan) {
  const std::string nine_tenths = "expect: [{circle: {}, scans: 0.9}]\n";
  watch(nine_tenths, {0, 1, 2, 3, 4, 5, 6, 7, 8});
  EXPECT_TRUE(results_.at(0).met) << "9 of 10 are 0.9, whatever binary fractions make of it";
  watch(nine_tenths, {0, 1, 2, 3, 4, 5, 6, 7});
  EXPECT_FALSE(results_.at(0).met);
  watch("expect: [{circle: {}, scans: some}]\n", {7});
  EXPECT_TRUE(results_.at(0).met);
  watch("expect: [{circle: {}, scans: some}]\n", {});
  EXPECT_FALSE(results_.at(0).met);
}

TEST_F(JudgeTest, MissesWhatNoScanCouldTell) {
  watch("expect: [{leg: {recall: 0.1}}, {between: [2.1, 2.9], circle: {at_most: 5}}]\n", {1});
  EXPECT_FALSE(results_.at(0).met) << "there was no leg to find";
  EXPECT_FALSE(results_.at(1).met) << "no scan within the window";
  EXPECT_EQ(results_.at(1).num_scans, 0);
}

TEST_F(JudgeTest, HoldsALaserWithoutTruthToCountsOnly) {
  watch("expect: [{circle: {near: col, within: 1}}, {circle: {at_most: 1}}]\n", {1, 2}, false);
  ASSERT_EQ(results_.size(), 1u);
  EXPECT_TRUE(results_.at(0).met);
  EXPECT_TRUE(gates_.empty());
}

TEST_F(JudgeTest, MeasuresNeedsOverTheirWindows) {
  watch(
      "score: {circle: {need: [{recall: 0.4}, {between: [0, 4], recall: 1}, {between: [5, 9], recall: 0.1}, "
      "{between: [0, 4], truths: 5}]}}\n",
      {0, 1, 2, 3, 4});
  ASSERT_EQ(gates_.size(), 4u);
  EXPECT_EQ(gates_[0].value, 0.5);
  EXPECT_EQ(gates_[1].value, 1.0);
  EXPECT_EQ(gates_[2].value, 0.0);
  EXPECT_EQ(gates_[3].value, 5.0);
  EXPECT_TRUE(gates_[0].met && gates_[1].met && !gates_[2].met && gates_[3].met);
}

TEST_F(JudgeTest, LeavesOutWhatIsAskedOfAnotherPreset) {
  watch(
      "expect: [{preset: paper, circle: {at_least: 2}}, {preset: robust, circle: {at_most: 1}}]\n"
      "score: {circle: {need: [{truths: 1}, {preset: paper, recall: 1}, {preset: robust, recall: 0.1}]}}\n",
      {1, 2, 3});
  ASSERT_EQ(gates_.size(), 2u);
  EXPECT_EQ(gates_.at(1).need.bound, 0.1);
  EXPECT_TRUE(gates_.at(1).met);
  ASSERT_EQ(results_.size(), 1u);
  EXPECT_TRUE(results_.at(0).met);
}

}  // namespace
}  // namespace scanbed::scenarios
