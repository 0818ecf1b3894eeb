// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_partners.hpp"

#include <gtest/gtest.h>

#include <random>

namespace scanbed {
namespace {

class LegPartnersTest : public ::testing::Test {
 protected:
  void read(const std::vector<LegPlace>& places, const std::vector<float>& sums) {
    table_.resize(static_cast<int>(places.size()));
    reader_.read(places, sums, table_);
  }
  float value(LegFeature feature, int candidate) const {
    return table_.at(static_cast<int>(feature), candidate);
  }

  static constexpr float kNone = LegPartnerReader::kUnlikely;

  LegPartnerReader reader_;
  LegFeatureTable table_;
};

TEST_F(LegPartnersTest, ACandidateAloneHasNone) {
  read({{{10, 15}, 2.0F, 0.0F}}, {5.0F});
  for (const LegFeature feature : {LegFeature::kPartner35, LegFeature::kPartner80, LegFeature::kRival}) {
    EXPECT_EQ(value(feature, 0), kNone);
  }
}

TEST_F(LegPartnersTest, TheLikeliestWithinReachCounts) {
  // At 0.2, 0.6 and 1.0 m from the first.
  read({{{10, 15}, 2.0F, 0.0F}, {{17, 20}, 2.0F, 0.2F}, {{22, 25}, 2.0F, 0.6F}, {{30, 35}, 2.0F, 1.0F}},
       {0.5F, -1.0F, 2.0F, 9.0F});
  EXPECT_EQ(value(LegFeature::kPartner35, 0), -1.0F);
  EXPECT_EQ(value(LegFeature::kPartner80, 0), 2.0F);
  // The one at 0.2 m has the others at 0.2, 0.4 and 0.8 m and more.
  EXPECT_EQ(value(LegFeature::kPartner35, 1), 0.5F);
  EXPECT_EQ(value(LegFeature::kPartner80, 1), 2.0F);
}

TEST_F(LegPartnersTest, WhatSharesBeamsIsARivalAndNoPartner) {
  // Two halves and the whole.
  read({{{10, 14}, 2.0F, -0.06F}, {{10, 19}, 2.0F, 0.0F}, {{15, 19}, 2.0F, 0.06F}}, {1.0F, 2.0F, 3.0F});
  EXPECT_EQ(value(LegFeature::kPartner35, 0), 3.0F);
  EXPECT_EQ(value(LegFeature::kRival, 0), 2.0F);
  EXPECT_EQ(value(LegFeature::kPartner35, 1), kNone);
  EXPECT_EQ(value(LegFeature::kRival, 1), 3.0F);
  EXPECT_EQ(value(LegFeature::kPartner35, 2), 1.0F);
  EXPECT_EQ(value(LegFeature::kRival, 2), 2.0F);
}

TEST_F(LegPartnersTest, WhatIsUnlikelyIsNone) {
  read({{{10, 15}, 2.0F, 0.0F}, {{17, 20}, 2.0F, 0.2F}}, {5.0F, kNone - 1.0F});
  EXPECT_EQ(value(LegFeature::kPartner35, 0), kNone);
  EXPECT_EQ(value(LegFeature::kPartner35, 1), 5.0F);
}

TEST_F(LegPartnersTest, EveryInstructionSetGivesTheSameBits) {
  std::mt19937 dice(3);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  std::vector<LegPlace> places;
  std::vector<float> sums;
  for (int i = 0; i < 61; ++i) {
    const int first = static_cast<int>(dice() % 300);
    places.push_back({{first, first + static_cast<int>(dice() % 20)}, 3.0F * unit(dice), 3.0F * unit(dice)});
    sums.push_back(8.0F * unit(dice) - 4.0F);
  }
  read(places, sums);
  LegFeatureTable plain;
  plain.resize(61);
  LegPartnerReader(InstructionSet::kPlain).read(places, sums, plain);
  for (int f = kNumOwnLegFeatures; f < kNumLegFeatures; ++f) {
    for (int c = 0; c < 61; ++c) EXPECT_EQ(plain.at(f, c), table_.at(f, c));
  }
}

}  // namespace
}  // namespace scanbed
