// SPDX-License-Identifier: MIT
#include "core/track/lost_people.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/track/made_features.hpp"

namespace scanbed {
namespace {

constexpr double kScanPeriod_s = 0.1;
constexpr double kAccel_m2_per_s3 = 1.0;

LiveTrack walker(int id, const Eigen::Vector2d& p_m, const Eigen::Vector2d& v_m_per_s) {
  LiveTrack track;
  track.id = id;
  track.kind = TrackKind::kPerson;
  track.is_mobile = true;
  track.num_hits = 20;
  track.point = {.p_m = p_m, .v_m_per_s = v_m_per_s, .var_p_m2 = 0.01, .var_v_m2_per_s2 = 0.04};
  return track;
}

LiveTrack newcomer_at(const Eigen::Vector2d& p_m) {
  LiveTrack track;
  track.num_hits = 1;
  track.point.p_m = p_m;
  return track;
}

void wait(LostPeople& lost, double time_s) {
  const LaserScan scan = testing::open_scan(0.0);
  for (int i = 0; i < std::lround(time_s / kScanPeriod_s); ++i)
    lost.predict({scan, {}, kScanPeriod_s}, kAccel_m2_per_s3, {});
}

TEST(LostPeopleTest, RemembersOnlyPeopleWhoWalkedAndWereReported) {
  LostPeople lost;
  LiveTrack leg = walker(1, {2.0, 0.0}, {1.0, 0.0});
  leg.kind = TrackKind::kLeg;
  LiveTrack standing = walker(2, {2.0, 0.0}, {0.0, 0.0});
  standing.is_mobile = false;
  lost.remember(leg);
  lost.remember(standing);
  lost.remember(walker(0, {2.0, 0.0}, {1.0, 0.0}));
  EXPECT_TRUE(lost.people().empty());
  lost.remember(walker(3, {2.0, 0.0}, {1.0, 0.0}));
  EXPECT_EQ(lost.people().size(), 1u);
}

TEST(LostPeopleTest, ForgetsAfterTheTimeInTheOptions) {
  LostPeople lost;
  lost.remember(walker(1, {2.0, 0.0}, {1.0, 0.0}));
  wait(lost, TrackOptions{}.max_lost_s - kScanPeriod_s);
  EXPECT_EQ(lost.people().size(), 1u);
  wait(lost, 2.0 * kScanPeriod_s);
  EXPECT_TRUE(lost.people().empty());
}

// v exp(-t / 2 s) leads v * 2 s farther in all; steps of 0.1 s overshoot by half a step of the first.
TEST(LostPeopleTest, ExpectsThemEverLessFarAheadAndEverLessExactly) {
  LostPeople lost;
  lost.remember(walker(1, {2.0, 0.0}, {1.0, 0.0}));
  wait(lost, 1.0);
  const LiveTrack after_1_s = lost.people()[0];
  EXPECT_NEAR(after_1_s.point.p_m.x(), 2.0 + 2.0 * (1.0 - std::exp(-0.5)), 0.05);
  wait(lost, 8.9);
  EXPECT_NEAR(lost.people()[0].point.p_m.x(), 2.0 + 2.0 * (1.0 - std::exp(-4.95)), 0.06);
  EXPECT_GT(lost.people()[0].point.var_p_m2, after_1_s.point.var_p_m2);
}

TEST(LostPeopleTest, OutOfSightAVelocityIsHalvedInTwiceTheLogarithmOf2) {
  MovingPoint point{.v_m_per_s = {1.0, -2.0}};
  for (int i = 0; i < 100; ++i) lose_way(point, 2.0 * std::log(2.0) / 100.0);
  EXPECT_TRUE(point.v_m_per_s.isApprox(Eigen::Vector2d(0.5, -1.0), 1e-9));
}

TEST(LostPeopleTest, ANewcomerIsRatherWhoIsExpectedThere) {
  LostPeople lost;
  lost.remember(walker(1, {2.0, 0.0}, {1.0, 0.0}));
  lost.remember(walker(2, {2.0, 2.0}, {1.0, 0.0}));
  wait(lost, 2.0);
  const LiveTrack newcomer = newcomer_at({3.0, 0.7});
  EXPECT_LT(surprise_of(newcomer, lost.people()[0]), surprise_of(newcomer, lost.people()[1]));
}

// Two Gaussians with the same centre: the narrow one is likelier within, the wide one without.
TEST(LostPeopleTest, AtTheSamePlaceWhoWentLastIsLikelier) {
  LostPeople lost;
  lost.remember(walker(1, {3.0, 0.0}, {0.0, 0.0}));
  wait(lost, 4.0);
  lost.remember(walker(2, {3.0, 0.0}, {0.0, 0.0}));
  wait(lost, 1.0);
  const LiveTrack near = newcomer_at({3.1, 0.0});
  EXPECT_GT(surprise_of(near, lost.people()[0]), surprise_of(near, lost.people()[1]));
  const LiveTrack far = newcomer_at({5.0, 0.0});
  EXPECT_LT(surprise_of(far, lost.people()[0]), surprise_of(far, lost.people()[1]));
}

TEST(LostPeopleTest, NobodyIsInTwoPlacesNorFasterThanWhoHurries) {
  LostPeople lost;
  lost.remember(walker(1, {2.0, 0.0}, {0.0, 0.0}));
  wait(lost, 1.0);
  const LiveTrack& missing = lost.people()[0];
  EXPECT_TRUE(std::isfinite(surprise_of(newcomer_at({4.25, 0.0}), missing)));  // 0.5 m and 1.8 m/s for 1 s
  EXPECT_TRUE(std::isinf(surprise_of(newcomer_at({4.35, 0.0}), missing)));
  LiveTrack elder = newcomer_at({2.0, 0.0});
  elder.age_s = 1.4;  // half a second side by side is what a leg's own track may have
  EXPECT_TRUE(std::isfinite(surprise_of(elder, missing)));
  elder.age_s = 1.6;
  EXPECT_TRUE(std::isinf(surprise_of(elder, missing)));
}

TEST(LostPeopleTest, TakesOverIdAndEvidence) {
  LiveTrack missing = walker(7, {2.0, 0.0}, {1.0, 0.0});
  missing.birth = 70;
  missing.log_odds = 2.0;
  missing.motion_evidence = 3.0;
  LiveTrack newcomer = newcomer_at({3.0, 1.0});
  newcomer.log_odds = 1.0;
  take_over(newcomer, missing, {});
  EXPECT_EQ(newcomer.id, 7);
  EXPECT_EQ(newcomer.birth, 70u);
  EXPECT_EQ(newcomer.kind, TrackKind::kPerson);
  EXPECT_EQ(newcomer.num_hits, 21);
  EXPECT_NEAR(newcomer.log_odds, 0.8 * 2.0 + 0.2 * 1.0, 1e-12);
  EXPECT_EQ(newcomer.motion_evidence, 3.0);
  EXPECT_TRUE(newcomer.point.p_m.isApprox(Eigen::Vector2d(3.0, 1.0)));
}

}  // namespace
}  // namespace scanbed
