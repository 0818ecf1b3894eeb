// SPDX-License-Identifier: MIT
#include "scenarios/load/expect.hpp"

#include <gtest/gtest.h>

namespace scanbed::scenarios {
namespace {

TEST(ExpectationTest, ReadsLikeASentence) {
  EXPECT_EQ(
      (Expectation{
           {.kind = FeatureKind::kCircle, .near = NearObject{"cyl", 0.2}, .at_least = 1}, {5.0, 12.0}, 1.0})
          .text(),
      "circle, at least 1 within 0.2 m of cyl, in all scans of 5 to 12 s");
  EXPECT_EQ((Expectation{{.kind = FeatureKind::kLeg, .at_most = 0}, {}, 0.95}).text(),
            "leg, at most 0, in 95 % of the scans");
  EXPECT_EQ((Expectation{{.kind = FeatureKind::kLine, .at_least = 2, .at_most = 4}, {}, 0.0}).text(),
            "line, 2 to 4, in one scan");
  EXPECT_EQ((Expectation{{.kind = FeatureKind::kLine, .at_least = 2, .at_most = 2}, {}, 1.0}).text(),
            "line, 2, in all scans");
  EXPECT_EQ((Expectation{{.kind = FeatureKind::kLine, .recall = 0.5, .precision = 0.9}, {}, 1.0}).text(),
            "line, recall >= 0.5, precision >= 0.9, in all scans");
}

TEST(ExpectationTest, KnowsWhatNeedsTruth) {
  EXPECT_FALSE((ScanCondition{.at_least = 1}).needs_truth());
  EXPECT_TRUE((ScanCondition{.recall = 0.5}).needs_truth());
  EXPECT_TRUE((ScanCondition{.near = NearObject{"a", 1.0}}).needs_truth());
}

}  // namespace
}  // namespace scanbed::scenarios
