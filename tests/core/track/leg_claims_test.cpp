// SPDX-License-Identifier: MIT
#include "core/track/leg_claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace scanbed {
namespace {

constexpr double kNoLimit = 1e9;

struct Problem {
  int num_tracks = 0;
  int num_legs = 0;
  std::vector<LegClaim> claims;
};

Problem random_problem(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&](int end) { return static_cast<int>(random() % static_cast<unsigned>(end)); };
  Problem problem{.num_tracks = 1 + below(4), .num_legs = 2 + below(5), .claims = {}};
  for (int track = 0; track < problem.num_tracks; ++track) {
    for (int i = below(6); i > 0; --i) {
      const int first = below(problem.num_legs);
      const int second = below(problem.num_legs);
      problem.claims.push_back({.track = track,
                                .first = first,
                                .second = second == first ? kNoLeg : second,
                                .gain = 0.25 * (below(100) - 10)});
    }
  }
  return problem;
}

// Gains of all ways to choose, the best first: every track in turn takes each claim, or none.
void choose(const Problem& problem, int track, std::set<int> taken, double gain, std::vector<double>& gains) {
  if (track == problem.num_tracks) {
    gains.push_back(gain);
    return;
  }
  choose(problem, track + 1, taken, gain, gains);
  for (const LegClaim& claim : problem.claims) {
    if (claim.track != track || claim.gain <= 0.0) continue;
    if (taken.contains(claim.first) || taken.contains(claim.second)) continue;
    std::set<int> with = taken;
    with.insert(claim.first);
    if (claim.second != kNoLeg) with.insert(claim.second);
    choose(problem, track + 1, with, gain + claim.gain, gains);
  }
}

std::vector<double> all_gains(const Problem& problem) {
  std::vector<double> gains;
  choose(problem, 0, {}, 0.0, gains);
  std::sort(gains.rbegin(), gains.rend());
  return gains;
}

void pose(const Problem& problem, LegClaims& claims) {
  claims.reset(problem.num_tracks, problem.num_legs);
  for (const LegClaim& claim : problem.claims) claims.add(claim);
}

TEST(LegClaimsTest, NobodyClaimsNothing) {
  LegClaims claims;
  claims.reset(2, 3);
  const std::span<const LegClaims::Answer> answers = claims.solve(5, kNoLimit);
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].gain, 0.0);
  EXPECT_EQ(claims.claim_of(answers[0], 1).first, kNoLeg);
  claims.reset(0, 0);
  EXPECT_EQ(claims.solve(5, kNoLimit).size(), 1u);
}

// Greedy would give both legs to the first track, for 10; with one for each there are 6 + 7.
TEST(LegClaimsTest, TheSumCounts) {
  LegClaims claims;
  claims.reset(2, 2);
  claims.add({.track = 0, .first = 0, .second = 1, .gain = 10.0});
  claims.add({.track = 0, .first = 0, .gain = 6.0});
  claims.add({.track = 1, .first = 1, .gain = 7.0});
  const std::span<const LegClaims::Answer> answers = claims.solve(1, kNoLimit);
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].gain, 13.0);
  EXPECT_EQ(claims.claim_of(answers[0], 0).first, 0);
  EXPECT_EQ(claims.claim_of(answers[0], 0).second, kNoLeg);
  EXPECT_EQ(claims.claim_of(answers[0], 1).first, 1);
}

TEST(LegClaimsTest, AnswersThatLoseMoreAreDropped) {
  LegClaims claims;
  claims.reset(2, 2);  // two groups: 5 or 0, and 3 or 0
  claims.add({.track = 0, .first = 0, .gain = 5.0});
  claims.add({.track = 1, .first = 1, .gain = 3.0});
  EXPECT_EQ(claims.solve(9, 2.0).size(), 1u);  // 8
  EXPECT_EQ(claims.solve(9, 4.0).size(), 2u);  // and 5
  EXPECT_EQ(claims.solve(9, 9.0).size(), 4u);  // and 3, and 0
  EXPECT_EQ(claims.solve(3, 9.0).size(), 3u);
}

TEST(LegClaimsTest, TheBestAnswersAreThoseOfASearchThroughAll) {
  LegClaims claims;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const Problem problem = random_problem(seed);
    pose(problem, claims);
    const std::vector<double> expected = all_gains(problem);
    const std::span<const LegClaims::Answer> answers = claims.solve(1000, kNoLimit);
    ASSERT_EQ(answers.size(), std::min<std::size_t>(expected.size(), 1000)) << seed;
    for (std::size_t i = 0; i < answers.size(); ++i) EXPECT_EQ(answers[i].gain, expected[i]) << seed;
  }
}

TEST(LegClaimsTest, NoLegIsGivenTwiceAndGainsAddUp) {
  LegClaims claims;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const Problem problem = random_problem(seed);
    pose(problem, claims);
    for (const LegClaims::Answer& answer : claims.solve(4, 8.0)) {
      std::set<int> taken;
      int num_legs = 0;
      double gain = 0.0;
      for (int track = 0; track < problem.num_tracks; ++track) {
        const LegClaim claim = claims.claim_of(answer, track);
        EXPECT_EQ(claim.track, track);
        gain += claim.gain;
        for (const int leg : {claim.first, claim.second}) {
          if (leg == kNoLeg) continue;
          taken.insert(leg);
          ++num_legs;
        }
      }
      EXPECT_EQ(static_cast<int>(taken.size()), num_legs) << seed;
      EXPECT_EQ(gain, answer.gain) << seed;
    }
  }
}

}  // namespace
}  // namespace scanbed
