// SPDX-License-Identifier: MIT
#include "core/track/live_track.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

constexpr double kPeriod_s = 0.1;

LaserScan hall(double time_s, bool with_column) {
  testing::IdealScene scene;
  scene.wall({6.0, -10.0}, {6.0, 10.0});
  if (with_column) scene.cylinder({1.5, 0.0}, 0.4);
  LaserScan scan = scene.scan();
  scan.time_s = time_s;
  return scan;
}

LiveTrack hit_twice(const Eigen::Vector2d& p_m, double log_odds) {
  const TrackOptions options;
  const LaserScan scan = hall(0.0, false);
  LiveTrack track;
  track.point = {.p_m = p_m, .var_p_m2 = 0.01, .var_v_m2_per_s2 = 0.01};
  track.count_hit(log_odds, {scan, {}, kPeriod_s}, options);
  track.count_hit(log_odds, {scan, {}, kPeriod_s}, options);
  return track;
}

// Scans without a hit until the track is dead, at most `limit`.
int misses_until_dead(LiveTrack& track, bool with_column, int limit) {
  const LaserScan scan = hall(0.0, with_column);
  int misses = 0;
  while (!track.is_dead && misses < limit) {
    track.predict({scan, {}, kPeriod_s}, 0.1);
    track.count_miss({scan, {}, kPeriod_s}, 0.25, {});
    ++misses;
  }
  return misses;
}

TEST(LiveTrackTest, LogOddsUndoTheLogisticFunction) {
  for (const double x : {-3.0, -0.5, 0.0, 2.0})
    EXPECT_NEAR(log_odds_of(1.0 / (1.0 + std::exp(-x))), x, 1e-12);
  EXPECT_EQ(log_odds_of(0.0), -4.0);
  EXPECT_EQ(log_odds_of(1.0), 4.0);
  EXPECT_EQ(log_odds_of(std::nan("")), -4.0);
}

TEST(LiveTrackTest, EvidenceIsAnExponentialMean) {
  const TrackOptions options;
  const LaserScan scan = hall(0.0, false);
  LiveTrack track;
  double expected = 1.0;
  track.count_hit(1.0, {scan, {}, kPeriod_s}, options);
  for (const double log_odds : {-1.0, 2.0, 0.5}) {
    track.count_hit(log_odds, {scan, {}, kPeriod_s}, options);
    expected = 0.8 * expected + 0.2 * log_odds;
  }
  EXPECT_NEAR(track.evidence(), expected, 1e-12);
  EXPECT_NEAR(track.score(), 1.0 / (1.0 + std::exp(-expected)), 1e-12);
}

TEST(LiveTrackTest, WalkingAddsToTheEvidenceUpToItsBound) {
  const TrackOptions options;
  LiveTrack track;
  for (int i = 0; i <= 40; ++i) {
    const LaserScan scan = hall(kPeriod_s * i, false);
    track.point.p_m = {0.1 * i, 0.0};
    track.count_hit(0.0, {scan, {}, kPeriod_s}, options);
  }
  EXPECT_TRUE(track.is_mobile);
  EXPECT_NEAR(track.evidence(), options.max_displacement_evidence, 1e-12);
}

// After a walk that is worth 3, 5 s of standing: exp(-5 / 20) of it is left with two legs in view, exp(-5 /
// 4) with one.
TEST(LiveTrackTest, WhoHasWalkedIsSomebodyForAWhile) {
  const TrackOptions options;
  for (const bool two_legs : {true, false}) {
    LiveTrack track;
    for (int i = 0; i <= 90; ++i) {
      const LaserScan scan = hall(kPeriod_s * i, false);
      track.predict({scan, {}, kPeriod_s}, 0.1);
      track.second_feature = two_legs ? 1 : kNoFeature;
      track.point.p_m = {0.1 * std::min(i, 40), 0.0};
      track.count_hit(0.0, {scan, {}, kPeriod_s}, options);
    }
    // The last 2 s of the walk still show as displacement in the window: 1 m, worth 3 or more, until 0.7 s
    // in.
    const double at_least = 3.0 * std::exp(-5.0 / (two_legs ? 20.0 : 4.0));
    EXPECT_GE(track.evidence(), at_least);
    EXPECT_LE(track.evidence(), at_least * std::exp(2.0 / (two_legs ? 20.0 : 4.0)));
  }
}

TEST(LiveTrackTest, TheGateGrowsWhileNothingIsSeen) {
  const TrackOptions options;
  LiveTrack track = hit_twice({2.0, 2.0}, 0.0);
  EXPECT_DOUBLE_EQ(track.gate_m(options), 0.15);
  const LaserScan scan = hall(0.0, false);
  track.predict({scan, {}, kPeriod_s}, 0.1);
  EXPECT_DOUBLE_EQ(track.gate_m(options), 0.15 + 1.8 * kPeriod_s);
  for (int i = 0; i < 10; ++i) track.predict({scan, {}, kPeriod_s}, 0.1);
  EXPECT_DOUBLE_EQ(track.gate_m(options), 0.6);
}

TEST(LiveTrackTest, APlaceSeenThroughIsForgottenSoonAHiddenOneLater) {
  LiveTrack in_the_open = hit_twice({3.0, 1.5}, 0.0);
  LiveTrack behind_the_column = hit_twice({3.0, 0.0}, 0.0);
  const int open = misses_until_dead(in_the_open, true, 1000);
  const int hidden = misses_until_dead(behind_the_column, true, 1000);
  EXPECT_GT(open, 2);  // scans through which it coasts
  EXPECT_LE(open, 6);
  EXPECT_NEAR(hidden, 30, 2);  // max_hidden_s of 3 s
}

// Misses through which a track is still taken to be where it is expected.
int misses_at_hand(LiveTrack track, const LaserScan& scan, double period_s = kPeriod_s) {
  int misses = 0;
  for (; misses < 1000; ++misses) {
    track.predict({scan, {}, period_s}, 0.1);
    track.count_miss({scan, {}, period_s}, 0.25, {});
    if (!track.is_at_hand({})) break;
  }
  return misses;
}

TEST(LiveTrackTest, CoastsBehindOthersButNotWhereBeamsPass) {
  const LaserScan scan = hall(0.0, true);
  EXPECT_EQ(misses_at_hand(hit_twice({3.0, 0.0}, 0.0), scan), TrackOptions{}.num_coasted_scans);
  EXPECT_EQ(misses_at_hand(hit_twice({3.0, 1.5}, 0.0), scan), 0);
}

TEST(LiveTrackTest, APersonIsNotGoneWhereBeamsPassBetweenTheLegs) {
  testing::IdealScene scene;
  scene.wall({6.0, -10.0}, {6.0, 10.0});
  scene.cylinder({3.0, 0.3}, 0.06);
  scene.cylinder({3.0, -0.3}, 0.06);
  LiveTrack track = hit_twice({3.0, 0.0}, 0.0);
  EXPECT_EQ(misses_at_hand(track, scene.scan()), 0);
  track.kind = TrackKind::kPerson;
  EXPECT_EQ(misses_at_hand(track, scene.scan()), 5);  // half a second
}

// The deviation of a place grows by 0.5 m/s times the time here: beyond 0.35 m after 0.7 s.
TEST(LiveTrackTest, CoastsOnlyWhileItsPlaceIsKnown) {
  const LaserScan scan = hall(0.0, true);
  LiveTrack track = hit_twice({3.0, 0.0}, 0.0);
  track.point = {.p_m = {3.0, 0.0}, .var_p_m2 = 1e-6, .var_v_m2_per_s2 = 0.25};
  EXPECT_EQ(misses_at_hand(track, scan, 0.2), 2);
  EXPECT_EQ(misses_at_hand(track, scan, 0.5), 1);
  EXPECT_EQ(misses_at_hand(track, scan, 0.8), 0);
}

// A place of which something unknown is seen for most of the time, and now and then something nearer or
// nothing: what stood there counts only against the time of what is seen.
TEST(LiveTrackTest, EachViewOfAPlaceHasItsOwnPatience) {
  const LaserScan hidden = hall(0.0, true);
  const LaserScan empty = hall(0.0, false);
  LaserScan occupied = empty;
  for (double& range_m : occupied.range_m) range_m = 3.0;
  const auto misses = [&](TrackKind kind, std::initializer_list<const LaserScan*> views) {
    LiveTrack track = hit_twice({3.0, 0.0}, 0.0);
    track.kind = kind;
    int count = 0;
    while (!track.is_dead && count < 1000) {
      const LaserScan& scan = **(views.begin() + count % static_cast<int>(views.size()));
      track.predict({scan, {}, kPeriod_s}, 0.1);
      track.count_miss({scan, {}, kPeriod_s}, 0.25, {});
      ++count;
    }
    return count;
  };
  EXPECT_NEAR(misses(TrackKind::kLeg, {&occupied}), 10, 1);           // 1 s
  EXPECT_NEAR(misses(TrackKind::kLeg, {&occupied, &hidden}), 20, 2);  // 1 s of 2 s
  EXPECT_NEAR(misses(TrackKind::kCylinder, {&occupied}), 30, 1);      // as long as hidden
  EXPECT_NEAR(misses(TrackKind::kCylinder, {&occupied, &hidden}), 60, 2);
  EXPECT_NEAR(misses(TrackKind::kCylinder, {&empty, &hidden, &hidden}), 15, 3);  // 0.4 s of nothing
}

TEST(LiveTrackTest, OneHitAloneIsNotRemembered) {
  const LaserScan scan = hall(0.0, true);
  LiveTrack track;
  track.point.p_m = {3.0, 0.0};
  track.count_hit(0.0, {scan, {}, kPeriod_s}, {});
  EXPECT_LE(misses_until_dead(track, true, 1000), 3);
}

TEST(LiveTrackTest, IsSettledOnlyAfterAWhileOfStanding) {
  const TrackOptions options;
  LiveTrack track;
  for (int i = 0; i <= 20; ++i) {
    const LaserScan scan = hall(kPeriod_s * i, false);
    track.count_hit(1.0, {scan, {}, kPeriod_s}, options);
    EXPECT_EQ(track.is_settled(), kPeriod_s * i > 0.65) << i;
  }
}

TEST(LiveTrackTest, IsSeenFromTheSensor) {
  LiveTrack track = hit_twice({2.0, 3.0}, 0.0);
  track.point.v_m_per_s = {1.0, 0.0};
  const Track seen = seen_from({{2.0, 1.0}, kPi / 2}, track);
  EXPECT_NEAR((seen.position_m - Eigen::Vector2d(2.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((seen.velocity_m_per_s - Eigen::Vector2d(0.0, -1.0)).norm(), 0.0, 1e-12);
}

TEST(LiveTrackTest, LegsOfThreeScansTellTracksApart) {
  const auto after = [](std::initializer_list<std::pair<int, int>> scans) {
    std::uint64_t legs = 0;
    for (const auto& [feature, second_feature] : scans) legs = with_legs(legs, feature, second_feature);
    return legs;
  };
  EXPECT_EQ(after({{5, 6}, {0, 1}, {2, kNoFeature}, {3, 4}}),
            after({{7, 8}, {0, 1}, {2, kNoFeature}, {3, 4}}));
  EXPECT_NE(after({{0, 1}, {2, kNoFeature}, {3, 4}}), after({{1, 0}, {2, kNoFeature}, {3, 4}}));
  EXPECT_NE(after({{0, 1}, {2, 0}, {3, 4}}), after({{0, 1}, {2, kNoFeature}, {3, 4}}));
}

TEST(LiveTrackTest, PeopleAreShownWhenLikelyEnoughAndCylindersAlways) {
  LiveTrack track;
  track.num_hits = 2;
  track.log_odds = log_odds_of(0.6);
  TrackOptions options;
  options.min_score = 0.7;
  EXPECT_FALSE(track.is_shown(options));
  options.min_score = 0.5;
  EXPECT_TRUE(track.is_shown(options));
  options.num_confirming_hits = 3;
  EXPECT_FALSE(track.is_shown(options));
  track.num_hits = 3;
  track.kind = TrackKind::kCylinder;
  options.min_score = 0.7;
  EXPECT_TRUE(track.is_shown(options));
}

}  // namespace
}  // namespace scanbed
