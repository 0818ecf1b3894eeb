// SPDX-License-Identifier: MIT
#include "scenarios/load/need.hpp"

#include <gtest/gtest.h>

namespace scanbed::scenarios {
namespace {

TEST(FindMetricTest, KnowsAllItsNames) {
  for (const FeatureKind kind : {FeatureKind::kLeg, FeatureKind::kCylinder}) {
    for (const std::string& name : metric_names(kind)) {
      ASSERT_TRUE(find_metric(name, kind).has_value()) << name;
      EXPECT_EQ(find_metric(name, kind)->name, name);
    }
  }
  // Five plain ones and the ten bands between five edges; four of tracks, false ones and truths.
  EXPECT_EQ(metric_names(FeatureKind::kLine).size(), 15u);
  EXPECT_EQ(metric_names(FeatureKind::kPerson).size(), 6u);
}

TEST(FindMetricTest, ReadsBandsFromTheirNames) {
  const Metric metric = find_metric("recall_0_4m", FeatureKind::kLine).value();
  EXPECT_EQ(metric.measure, Measure::kRecallInBand);
  EXPECT_EQ(metric.from_m, 0.0);
  EXPECT_EQ(metric.to_m, 4.0);
}

TEST(FindMetricTest, BoundsErrorsFromAboveAndSharesFromBelow) {
  EXPECT_TRUE(find_metric("fp_per_scan", FeatureKind::kLeg)->at_most);
  EXPECT_TRUE(find_metric("fp_per_scan", FeatureKind::kPerson)->at_most);
  EXPECT_TRUE(find_metric("rms_error", FeatureKind::kLeg)->at_most);
  EXPECT_FALSE(find_metric("precision", FeatureKind::kLeg)->at_most);
  EXPECT_FALSE(find_metric("recall", FeatureKind::kLeg)->at_most);
  EXPECT_FALSE(find_metric("truths", FeatureKind::kLeg)->at_most);
}

TEST(FindMetricTest, KnowsNoOthers) {
  for (const char* name : {"recall_4_2m", "recall_1_3m", "", "mota"}) {
    EXPECT_FALSE(find_metric(name, FeatureKind::kLine).has_value()) << name;
  }
  EXPECT_FALSE(find_metric("recall", FeatureKind::kCylinder));
}

TEST(FeatureKindTest, HasTheNamesOfScenarioFiles) {
  EXPECT_EQ(to_string(FeatureKind::kLine), "line");
  EXPECT_EQ(to_string(FeatureKind::kCircle), "circle");
  EXPECT_EQ(to_string(FeatureKind::kLeg), "leg");
  EXPECT_EQ(to_string(FeatureKind::kPerson), "person");
  EXPECT_EQ(to_string(FeatureKind::kCylinder), "cylinder");
}

}  // namespace
}  // namespace scanbed::scenarios
