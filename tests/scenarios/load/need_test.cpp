// SPDX-License-Identifier: MIT
#include "scenarios/load/need.hpp"

#include <gtest/gtest.h>

namespace scanbed::scenarios {
namespace {

TEST(FindMetricTest, KnowsAllItsNames) {
  for (const std::string& name : metric_names()) {
    ASSERT_TRUE(find_metric(name).has_value()) << name;
    EXPECT_EQ(find_metric(name)->name, name);
  }
  // Five plain ones, the ten bands between five edges, four of tracks.
  EXPECT_EQ(metric_names().size(), 19u);
}

TEST(FindMetricTest, ReadsBandsFromTheirNames) {
  const Metric metric = find_metric("recall_0_4m").value();
  EXPECT_EQ(metric.measure, Measure::kRecallInBand);
  EXPECT_EQ(metric.from_m, 0.0);
  EXPECT_EQ(metric.to_m, 4.0);
}

TEST(FindMetricTest, BoundsErrorsFromAboveAndSharesFromBelow) {
  EXPECT_TRUE(find_metric("fp_per_scan")->at_most);
  EXPECT_TRUE(find_metric("rms_error")->at_most);
  EXPECT_FALSE(find_metric("precision")->at_most);
  EXPECT_FALSE(find_metric("recall")->at_most);
  EXPECT_FALSE(find_metric("truths")->at_most);
}

TEST(FindMetricTest, KnowsNoOthers) {
  EXPECT_FALSE(find_metric("recall_4_2m").has_value());
  EXPECT_FALSE(find_metric("recall_1_3m").has_value());
  EXPECT_FALSE(find_metric("").has_value());
}

TEST(FeatureKindTest, HasTheNamesOfScenarioFiles) {
  EXPECT_EQ(to_string(FeatureKind::kLine), "line");
  EXPECT_EQ(to_string(FeatureKind::kCircle), "circle");
  EXPECT_EQ(to_string(FeatureKind::kLeg), "leg");
  EXPECT_EQ(to_string(FeatureKind::kPerson), "person");
  EXPECT_EQ(to_string(FeatureKind::kCylinder), "cylinder");
}

TEST(NeedTest, EachKindHasItsMetrics) {
  EXPECT_TRUE(find_metric("mota", FeatureKind::kPerson));
  EXPECT_FALSE(find_metric("mota", FeatureKind::kLine));
  EXPECT_FALSE(find_metric("recall", FeatureKind::kCylinder));
  EXPECT_TRUE(find_metric("truths", FeatureKind::kPerson));
  EXPECT_TRUE(find_metric("truths", FeatureKind::kLeg));
  for (const FeatureKind kind : {FeatureKind::kLeg, FeatureKind::kCylinder}) {
    for (const std::string& name : metric_names(kind)) EXPECT_TRUE(find_metric(name, kind)) << name;
  }
}

}  // namespace
}  // namespace scanbed::scenarios
