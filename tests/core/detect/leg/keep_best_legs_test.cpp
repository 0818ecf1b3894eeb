// SPDX-License-Identifier: MIT
#include "core/detect/leg/keep_best_legs.hpp"

#include <gtest/gtest.h>

namespace scanbed {
namespace {

Leg leg(int first_beam, int last_beam, double x_m, double score) {
  return {{first_beam, last_beam}, {x_m, 0.0}, score};
}

TEST(KeepBestLegsTest, OfThoseThatShareABeamTheBestStays) {
  std::vector<Leg> legs = {leg(10, 14, 1.0, 0.6), leg(14, 20, 1.5, 0.9), leg(20, 22, 2.0, 0.8)};
  keep_best_legs(legs);
  ASSERT_EQ(legs.size(), 1u);
  EXPECT_EQ(legs[0].score, 0.9);
}

TEST(KeepBestLegsTest, OfThoseThatStandWithinAHandsBreadthTheBestStays) {
  std::vector<Leg> legs = {leg(10, 14, 1.0, 0.6), leg(15, 20, 1.099, 0.9), leg(21, 25, 1.201, 0.8)};
  keep_best_legs(legs);
  ASSERT_EQ(legs.size(), 2u);
  EXPECT_EQ(legs[0].score, 0.9);
  EXPECT_EQ(legs[1].score, 0.8);
}

// The middle one is one with either side; it goes, and both sides stay.
TEST(KeepBestLegsTest, WhatWasDroppedDropsNothingElse) {
  std::vector<Leg> legs = {leg(10, 14, 1.0, 0.9), leg(14, 20, 1.5, 0.7), leg(20, 24, 2.0, 0.6)};
  keep_best_legs(legs);
  ASSERT_EQ(legs.size(), 2u);
  EXPECT_EQ(legs[0].beams.first, 10);
  EXPECT_EQ(legs[1].beams.first, 20);
}

TEST(KeepBestLegsTest, EqualScoresAreSettledByBeams) {
  std::vector<Leg> legs = {leg(12, 16, 1.1, 0.5), leg(10, 14, 1.0, 0.5)};
  keep_best_legs(legs);
  ASSERT_EQ(legs.size(), 1u);
  EXPECT_EQ(legs[0].beams.first, 10);
}

TEST(KeepBestLegsTest, NothingOfNothing) {
  std::vector<Leg> legs;
  keep_best_legs(legs);
  EXPECT_TRUE(legs.empty());
}

}  // namespace
}  // namespace scanbed
