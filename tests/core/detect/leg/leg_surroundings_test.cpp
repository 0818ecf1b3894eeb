// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_surroundings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace scanbed {
namespace {

constexpr float kNothing_m = 1e3F;

/// Points strewn about a candidate in the origin.
class LegSurroundingsTest : public ::testing::Test {
 protected:
  void strew(int num_beams, unsigned seed) {
    std::mt19937 dice(seed);
    std::uniform_real_distribution<float> coordinate_m(-1.2F, 1.2F), range_m(1.0F, 5.0F);
    for (std::vector<float>* values : {&x_m_, &y_m_, &range_m_})
      values->assign(num_beams + kNumLanes, kNothing_m);
    around_.off_wall_m2.fill(num_beams + kNumLanes, LegSurroundings::kFar_m2);
    for (int i = 0; i < num_beams; ++i) {
      if (dice() % 10 == 0) continue;
      x_m_[i] = coordinate_m(dice);
      y_m_[i] = coordinate_m(dice);
      range_m_[i] = range_m(dice);
      if (dice() % 3 == 0) *around_.off_wall_m2.from(i) = 0.0F;
    }
    around_.x_m.copy(x_m_);
    around_.y_m.copy(y_m_);
    around_.range_m.copy(range_m_);
  }

  NearEchoes near_one_by_one(const BeamSpan& own) const {
    NearEchoes near{.nearest_m2 = 1.0F, .nearest_wall_m2 = 1.0F};
    for (int i = 0; i + kNumLanes < static_cast<int>(x_m_.size()); ++i) {
      if (i >= own.first && i <= own.last) continue;
      const float d2 = x_m_[i] * x_m_[i] + y_m_[i] * y_m_[i];
      const bool on_wall = *around_.off_wall_m2.from(i) == 0.0F;
      near.num_within30 += d2 < 0.09F ? 1 : 0;
      near.num_within50 += d2 < 0.25F ? 1 : 0;
      near.num_within100 += d2 < 1.0F ? 1 : 0;
      near.num_wall100 += on_wall && d2 < 1.0F ? 1 : 0;
      near.nearest_m2 = std::min(near.nearest_m2, d2);
      if (on_wall) near.nearest_wall_m2 = std::min(near.nearest_wall_m2, d2);
    }
    return near;
  }

  BesideBeams beside_one_by_one(const BeamSpan& own, const BeamSpan& all) const {
    BesideBeams beside{.nearest_m = 2.0F, .behind_m = 2.0F};
    for (int i = all.first; i <= all.last; ++i) {
      if (i >= own.first && i <= own.last) continue;
      const float farther = range_m_[i] - kOwn_m;
      beside.num_open25 += farther > 0.25F ? 1 : 0;
      beside.num_open60 += farther > 0.6F ? 1 : 0;
      beside.num_hidden += farther < -0.15F ? 1 : 0;
      beside.nearest_m = std::min(beside.nearest_m, std::abs(farther));
      if (farther > -0.1F) beside.behind_m = std::min(beside.behind_m, farther);
    }
    return beside;
  }

  static constexpr float kOwn_m = 3.0F;
  std::vector<float> x_m_, y_m_, range_m_;
  LegSurroundings around_;
};

TEST_F(LegSurroundingsTest, EveryEchoNearCountsOnceButItsOwn) {
  for (const int num_beams : {1, 7, 8, 9, 40}) {
    strew(num_beams, static_cast<unsigned>(num_beams));
    for (int first = 0; first < num_beams; ++first) {
      const LegPlace own{{first, std::min(num_beams - 1, first + first % 5)}};
      const NearEchoes expected = near_one_by_one(own.beams);
      for (const InstructionSet set : {InstructionSet::kPlain, widest_instruction_set()}) {
        const NearEchoes near = count_near(set, {around_, own, kOwn_m}, {0, num_beams - 1});
        EXPECT_EQ(near.num_within30, expected.num_within30);
        EXPECT_EQ(near.num_within50, expected.num_within50);
        EXPECT_EQ(near.num_within100, expected.num_within100);
        EXPECT_EQ(near.num_wall100, expected.num_wall100);
        EXPECT_EQ(near.nearest_m2, expected.nearest_m2);
        EXPECT_EQ(near.nearest_wall_m2, expected.nearest_wall_m2);
      }
    }
  }
}

TEST_F(LegSurroundingsTest, BeamsBesideEndWhereTheyAreSaidTo) {
  constexpr int kNumBeams = 40;
  strew(kNumBeams, 3);
  for (int first = 0; first < kNumBeams; ++first) {
    const LegPlace own{{first, std::min(kNumBeams - 1, first + first % 5)}};
    for (int half = 1; half < 20; ++half) {
      const BeamSpan all{std::max(0, first - half), std::min(kNumBeams - 1, own.beams.last + half)};
      const BesideBeams expected = beside_one_by_one(own.beams, all);
      for (const InstructionSet set : {InstructionSet::kPlain, widest_instruction_set()}) {
        const BesideBeams beside = look_beside(set, {around_, own, kOwn_m}, all);
        EXPECT_EQ(beside.num_open25, expected.num_open25);
        EXPECT_EQ(beside.num_open60, expected.num_open60);
        EXPECT_EQ(beside.num_hidden, expected.num_hidden);
        EXPECT_EQ(beside.nearest_m, expected.nearest_m);
        EXPECT_EQ(beside.behind_m, expected.behind_m);
      }
    }
  }
}

TEST_F(LegSurroundingsTest, TheNearestSmallRunIsNotOnesOwn) {
  const std::vector<SmallRun> runs = {{{{10, 14}, 0.0F, 0.0F}, 0.1F},
                                      {{{16, 18}, 0.3F, 0.0F}, 0.2F},
                                      {{{20, 22}, 0.0F, 0.9F}, 0.15F},
                                      {{{30, 33}, 4.0F, 0.0F}, 0.05F}};
  const LegPlace places[] = {{{12, 13}, 0.0F, 0.0F}, {{14, 17}, 0.1F, 0.0F}, {{40, 41}, 9.0F, 9.0F}};
  LegPlaceLanes own;
  own.read(places);
  for (const InstructionSet set : {InstructionSet::kPlain, widest_instruction_set()}) {
    SmallNeighbours found;
    find_small(set, runs, own, found);
    EXPECT_EQ(found.num[0], 2);
    EXPECT_FLOAT_EQ(found.nearest_m2[0], 0.09F);
    EXPECT_EQ(found.width_m[0], 0.2F);
    EXPECT_EQ(found.num[1], 1);  // the first two share beams with it
    EXPECT_EQ(found.width_m[1], 0.15F);
    EXPECT_EQ(found.num[2], 0);
    EXPECT_FLOAT_EQ(found.nearest_m2[2], 2.25F);
    EXPECT_EQ(found.width_m[2], -1.0F);
  }
}

}  // namespace
}  // namespace scanbed
