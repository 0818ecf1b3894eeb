// SPDX-License-Identifier: MIT
#include "scenarios/run/gates.hpp"

#include <gtest/gtest.h>

#include "tests/scenarios/made_scores.hpp"

namespace scanbed::scenarios {
namespace {

std::optional<double> measured(FeatureKind kind, std::string_view name) {
  return measure(testing::made_scores(), kind, find_metric(name, kind).value());
}

TEST(MeasureTest, ComputesEachMetric) {
  EXPECT_DOUBLE_EQ(measured(FeatureKind::kCircle, "recall").value(), 0.8);
  EXPECT_DOUBLE_EQ(measured(FeatureKind::kCircle, "precision").value(), 0.5);
  EXPECT_DOUBLE_EQ(measured(FeatureKind::kCircle, "fp_per_scan").value(), 0.8);
  EXPECT_DOUBLE_EQ(measured(FeatureKind::kCircle, "rms_error").value(), 0.03);
  EXPECT_DOUBLE_EQ(measured(FeatureKind::kCircle, "truths").value(), 10.0);
  EXPECT_DOUBLE_EQ(measured(FeatureKind::kLeg, "fp_per_scan").value(), 0.1);
}

TEST(MeasureTest, PoolsBands) {
  EXPECT_DOUBLE_EQ(measured(FeatureKind::kCircle, "recall_2_4m").value(), 3.0 / 4.0);
  EXPECT_DOUBLE_EQ(measured(FeatureKind::kCircle, "recall_0_4m").value(), 3.0 / 4.0);
  EXPECT_DOUBLE_EQ(measured(FeatureKind::kCircle, "recall_0_8m").value(), 8.0 / 10.0);
}

TEST(MeasureTest, IsEmptyWhereThereIsNothing) {
  for (const char* name : {"recall", "precision", "rms_error", "recall_0_4m"}) {
    EXPECT_FALSE(measured(FeatureKind::kLine, name).has_value()) << name;
  }
  EXPECT_FALSE(measured(FeatureKind::kCircle, "recall_0_2m").has_value());
  EXPECT_FALSE(measure(Scores{}, FeatureKind::kLeg, find_metric("fp_per_scan", FeatureKind::kLeg).value())
                   .has_value());
}

bool reaches(FeatureKind kind, std::string_view name, double bound) {
  return evaluate({kind, find_metric(name, kind).value(), bound}, testing::made_scores()).met;
}

TEST(EvaluateTest, HoldsSharesFromBelowAndErrorsFromAbove) {
  EXPECT_TRUE(reaches(FeatureKind::kCircle, "recall", 0.8));
  EXPECT_FALSE(reaches(FeatureKind::kCircle, "recall", 0.81));
  EXPECT_TRUE(reaches(FeatureKind::kLeg, "fp_per_scan", 0.1));
  EXPECT_FALSE(reaches(FeatureKind::kLeg, "fp_per_scan", 0.09));
}

TEST(EvaluateTest, MissesAGateThatNothingWasMeasuredFor) {
  EXPECT_FALSE(reaches(FeatureKind::kLine, "recall", 0.0));
}

TEST(GatesTest, MeasuresWhatWasFollowed) {
  Scores scores;
  scores.num_scans = 20;
  const auto measured = [&](const char* name) {
    return measure(scores, FeatureKind::kPerson, find_metric(name, FeatureKind::kPerson).value());
  };
  EXPECT_FALSE(measured("mota"));  // nothing was followed
  scores.person = TrackTally{.num_truths = 10,
                             .num_matches = 8,
                             .num_false = 3,
                             .num_switches = 1,
                             .sum_error_m = 0.8,
                             .object_time_s = 30.0,
                             .num_identity_true = 5,
                             .num_identity_tracks = 10};
  EXPECT_DOUBLE_EQ(measured("mota").value(), 0.4);
  EXPECT_DOUBLE_EQ(measured("fp_per_scan").value(), 0.15);
  EXPECT_DOUBLE_EQ(measured("motp").value(), 0.1);
  EXPECT_DOUBLE_EQ(measured("id_switches_per_minute").value(), 2.0);
  EXPECT_DOUBLE_EQ(measured("idf1").value(), 0.5);
  EXPECT_DOUBLE_EQ(measured("truths").value(), 10.0);
}

// Where nobody is, a tracker may still see somebody: that can be held to a bar.
TEST(GatesTest, CountsFalseTracksWhereThereIsNothingToFollow) {
  Scores scores;
  scores.num_scans = 10;
  scores.person = TrackTally{.num_false = 5, .num_identity_tracks = 5};
  const auto measured = [&](const char* name) {
    return measure(scores, FeatureKind::kPerson, find_metric(name, FeatureKind::kPerson).value());
  };
  EXPECT_DOUBLE_EQ(measured("fp_per_scan").value(), 0.5);
  EXPECT_DOUBLE_EQ(measured("truths").value(), 0.0);
  EXPECT_DOUBLE_EQ(measured("idf1").value(), 0.0);
  for (const char* name : {"mota", "motp", "id_switches_per_minute"}) EXPECT_FALSE(measured(name)) << name;
}

}  // namespace
}  // namespace scanbed::scenarios
