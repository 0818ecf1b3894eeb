// SPDX-License-Identifier: MIT
#include "sim/world/gait.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kGaitRounding = 1e-9;
constexpr double kLaser_m = 0.28;
constexpr double kSample_s = 1e-3;

Walker walker_along_x(double speed_m_per_s, double length_m = 1000.0) {
  Walker walker;
  walker.id = "anna";
  walker.path.points_m = {{0.0, 0.0}, {length_m, 0.0}};
  walker.speed_m_per_s = speed_m_per_s;
  return walker;
}

bool stands(const Gait& gait, double t_s) {
  return (gait.state_at(t_s + 1e-6).left_foot_m - gait.state_at(t_s).left_foot_m).norm() < 1e-12;
}

/// x of each place where the left or the right foot stood, in order, between two times.
std::vector<double> footprints_x(const Gait& gait, double from_s, double to_s) {
  std::vector<double> prints;
  for (double t_s = from_s; t_s < to_s; t_s += kSample_s) {
    const WalkerState a = gait.state_at(t_s);
    const WalkerState b = gait.state_at(t_s + 1e-6);
    if (a.left_foot_m == b.left_foot_m) prints.push_back(a.left_foot_m.x());
    if (a.right_foot_m == b.right_foot_m) prints.push_back(a.right_foot_m.x());
  }
  std::sort(prints.begin(), prints.end());
  const auto same = [](double a, double b) { return std::abs(a - b) < 1e-6; };
  prints.erase(std::unique(prints.begin(), prints.end(), same), prints.end());
  return prints;
}

TEST(GaitTest, NormalWalkingHasThePublishedFigures) {
  EXPECT_DOUBLE_EQ(step_length_m(1.37), 0.72);
  EXPECT_NEAR(cycle_s(1.37), 1.05, 0.005);              // published to two digits
  EXPECT_NEAR(2.0 * 60.0 / cycle_s(1.37), 114.0, 0.5);  // steps per minute, published to a whole number
}

TEST(GaitTest, StepsTimesCadenceIsTheSpeedAtAnySpeed) {
  for (const double v : {0.3, 0.8, 1.0, 1.37, 2.0}) {
    EXPECT_NEAR(2.0 * step_length_m(v) / cycle_s(v), v, kGaitRounding);
    EXPECT_NEAR(step_length_m(v) * cycle_s(v), 0.72 * cycle_s(1.37), kGaitRounding) << "walk ratio at " << v;
  }
}

TEST(GaitTest, FootprintsAreOneStepApart) {
  const std::vector<double> prints = footprints_x(Gait(walker_along_x(1.37), 0, kLaser_m), 0.0, 20.0);
  ASSERT_GT(prints.size(), 30U);
  for (std::size_t i = 1; i < prints.size(); ++i) EXPECT_NEAR(prints[i] - prints[i - 1], 0.72, kGaitRounding);
}

TEST(GaitTest, CadenceIs114StepsAMinute) {
  const std::vector<double> prints = footprints_x(Gait(walker_along_x(1.37), 0, kLaser_m), 1.0, 61.0);
  EXPECT_NEAR(static_cast<double>(prints.size()), 114.0, 2.0);  // one print more or less at either end
}

TEST(GaitTest, AFootStandsForSixtyPercentOfTheCycle) {
  const Gait gait(walker_along_x(1.37), 0, kLaser_m);
  const int num_samples = 2000;
  int num_standing = 0;
  for (int i = 0; i < num_samples; ++i) num_standing += stands(gait, (i + 0.5) * cycle_s(1.37) / num_samples);
  EXPECT_NEAR(static_cast<double>(num_standing) / num_samples, 0.6, 2.0 / num_samples);
}

TEST(GaitTest, ThePelvisKeepsItsSpeedAndIsOverTheFootInTheMiddleOfStance) {
  const Gait gait(walker_along_x(1.37), 0, kLaser_m);
  for (int cycle = 1; cycle < 5; ++cycle) {
    const WalkerState left = gait.state_at(cycle * cycle_s(1.37));
    EXPECT_NEAR(left.X_WP.p_m.x(), cycle * 1.44, kGaitRounding);
    EXPECT_NEAR(left.left_foot_m.x(), left.X_WP.p_m.x(), kGaitRounding);
    const WalkerState right = gait.state_at((cycle + 0.5) * cycle_s(1.37));
    EXPECT_NEAR(right.right_foot_m.x(), right.X_WP.p_m.x(), kGaitRounding);
  }
}

TEST(GaitTest, ShinsMoveAsTheRigidLegSays) {
  const Walker walker = walker_along_x(1.37);
  const Gait gait(walker, 0, kLaser_m);
  const double ratio = kLaser_m / walker.leg_length_m;
  const double foot_swing_m_per_s = 1.44 / (0.4 * cycle_s(1.37));
  const auto shin_speed = [&](double t_s) {
    return (gait.state_at(t_s + 1e-4).left_leg_m - gait.state_at(t_s).left_leg_m).norm() / 1e-4;
  };
  const double mid_stance_s = 3.0 * cycle_s(1.37);
  const double mid_swing_s = 3.5 * cycle_s(1.37);
  EXPECT_NEAR(shin_speed(mid_stance_s), ratio * 1.37, 1e-6);
  EXPECT_NEAR(shin_speed(mid_swing_s), (1.0 - ratio) * foot_swing_m_per_s + ratio * 1.37, 1e-6);
  EXPECT_NEAR(shin_speed(mid_swing_s), 2.8, 0.05);  // the figures that gait studies lead to
  EXPECT_NEAR(shin_speed(mid_stance_s), 0.4, 0.05);
}

TEST(GaitTest, LegsAreThirteenCentimetresApartAtTheLasersHeight) {
  const WalkerState state = Gait(walker_along_x(1.37), 0, kLaser_m).state_at(12.3);
  EXPECT_NEAR(state.left_leg_m.y() - state.right_leg_m.y(), 0.13, 0.005);  // published to two digits
  EXPECT_NEAR(state.left_foot_m.y() - state.right_foot_m.y(), 0.10, kGaitRounding);
}

TEST(GaitTest, TheLegRunsFromTheFootToTheHip) {
  const Walker walker = walker_along_x(1.0);
  const WalkerState floor = Gait(walker, 0, 0.0).state_at(2.2);
  EXPECT_EQ(floor.left_leg_m, floor.left_foot_m);
  for (const double height_m : {walker.leg_length_m, 1.5}) {
    const WalkerState hip = Gait(walker, 0, height_m).state_at(2.2);
    EXPECT_NEAR((hip.right_leg_m - hip.X_WP * Vector2d(0.0, -0.1)).norm(), 0.0, kGaitRounding);
  }
}

TEST(GaitTest, StandsWithFeetSideBySideBeforeAndBehindAnOpenPath) {
  const Gait gait(walker_along_x(1.2, 5.0), 0, kLaser_m);
  const WalkerState start = gait.state_at(0.0);
  EXPECT_NEAR((start.left_foot_m - Vector2d(0.0, 0.05)).norm(), 0.0, kGaitRounding);
  EXPECT_NEAR((start.right_foot_m - Vector2d(0.0, -0.05)).norm(), 0.0, kGaitRounding);
  const WalkerState end = gait.state_at(60.0);
  EXPECT_TRUE(end.present);
  EXPECT_NEAR((end.left_foot_m - Vector2d(5.0, 0.05)).norm(), 0.0, kGaitRounding);
  EXPECT_NEAR((end.right_foot_m - Vector2d(5.0, -0.05)).norm(), 0.0, kGaitRounding);
  EXPECT_NEAR((end.X_WP.p_m - Vector2d(5.0, 0.0)).norm(), 0.0, kGaitRounding);
}

TEST(GaitTest, IsThereFromItsStartUntilItLeaves) {
  Walker walker = walker_along_x(1.0, 5.0);
  walker.start_s = 3.0;
  walker.path.leave = true;
  const Gait gait(walker, 4, kLaser_m);
  EXPECT_EQ(gait.state_at(0.0).walker, 4);
  EXPECT_FALSE(gait.state_at(2.999).present);
  EXPECT_TRUE(gait.state_at(3.0).present);
  EXPECT_NEAR(gait.state_at(5.0).X_WP.p_m.x(), 2.0, kGaitRounding);
  EXPECT_TRUE(gait.state_at(7.999).present);
  EXPECT_FALSE(gait.state_at(8.001).present);
}

// The swinging foot is the fastest: no leg moves farther in a sample than it could, however sharp the corner.
// The footprints either side of a reversal are at most a stride and two half widths apart.
TEST(GaitTest, LegsNeverJumpEvenAtSharpCornersAndReversals) {
  Walker walker = walker_along_x(1.37);
  walker.path.loop = true;
  for (const auto& points :
       {std::vector<Vector2d>{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, std::vector<Vector2d>{{0, 0}, {4, 0}}}) {
    walker.path.points_m = points;
    const Gait gait(walker, 0, kLaser_m);
    const double foot_m_per_s = (1.44 + 0.2) / (0.4 * cycle_s(1.37));
    // Hips turn by at most half a turn in 0.3 m of walking, 0.1 m from the axis.
    const double hip_m_per_s = 1.37 + 0.1 * kPi * 1.37 / 0.3;
    const double limit_m = kSample_s * (foot_m_per_s + hip_m_per_s);
    for (double t_s = 0.0; t_s < 30.0; t_s += kSample_s) {
      const WalkerState a = gait.state_at(t_s);
      const WalkerState b = gait.state_at(t_s + kSample_s);
      ASSERT_LE((b.left_leg_m - a.left_leg_m).norm(), limit_m) << t_s;
      ASSERT_LE((b.right_leg_m - a.right_leg_m).norm(), limit_m) << t_s;
    }
  }
}

TEST(GaitTest, StandsAtAStopWithFeetSideBySideAndGoesOn) {
  Walker walker = walker_along_x(1.0, 10.0);
  walker.stops = {{.at_m = 3.0, .for_s = 4.0}};
  const Gait gait(walker, 0, kLaser_m);
  for (const double t_s : {3.0, 5.0, 7.0})
    EXPECT_NEAR(gait.state_at(t_s).X_WP.p_m.x(), 3.0, kGaitRounding) << t_s;
  const WalkerState standing = gait.state_at(6.0);
  EXPECT_NEAR((standing.left_foot_m - Vector2d(3.0, 0.05)).norm(), 0.0, kGaitRounding);
  EXPECT_NEAR((standing.right_foot_m - Vector2d(3.0, -0.05)).norm(), 0.0, kGaitRounding);
  EXPECT_NEAR(gait.state_at(9.0).X_WP.p_m.x(), 5.0, kGaitRounding);
}

TEST(GaitTest, TurnsOnTheSpotAtAStopAndBackBeforeItGoesOn) {
  Walker walker = walker_along_x(1.0, 10.0);
  walker.stops = {{.at_m = 3.0, .for_s = 10.0, .turn_rad = -1.2}};
  const Gait gait(walker, 0, kLaser_m);
  EXPECT_NEAR(gait.state_at(3.5).X_WP.theta_rad, 0.0, kGaitRounding);
  const WalkerState turned = gait.state_at(8.0);
  EXPECT_NEAR(turned.X_WP.theta_rad, -1.2, kGaitRounding);
  EXPECT_NEAR((turned.left_foot_m - turned.X_WP * Vector2d(0.0, 0.05)).norm(), 0.0, kGaitRounding);
  EXPECT_NEAR(gait.state_at(13.0).X_WP.theta_rad, 0.0, kGaitRounding);
}

TEST(GaitTest, AStopForGoodIsAStandingPerson) {
  Walker walker = walker_along_x(1.0, 10.0);
  walker.stops = {{.at_m = 0.0, .for_s = std::numeric_limits<double>::infinity()}};
  const Gait gait(walker, 0, kLaser_m);
  for (const double t_s : {0.0, 1.0, 1e4}) {
    EXPECT_TRUE(gait.state_at(t_s).present);
    EXPECT_NEAR(gait.state_at(t_s).X_WP.p_m.x(), 0.0, kGaitRounding);
  }
  EXPECT_NEAR((gait.state_at(1e4).right_foot_m - Vector2d(0.0, -0.05)).norm(), 0.0, kGaitRounding);
}

TEST(GaitTest, WalksBesideItsPath) {
  Walker walker = walker_along_x(1.0, 10.0);
  walker.lateral_m = -0.4;
  const WalkerState state = Gait(walker, 0, kLaser_m).state_at(2.0);
  EXPECT_NEAR((state.X_WP.p_m - Vector2d(2.0, -0.4)).norm(), 0.0, kGaitRounding);
  EXPECT_NEAR(0.5 * (state.left_foot_m.y() + state.right_foot_m.y()), -0.4, kGaitRounding);
}

TEST(GaitTest, LegsNeverJumpAtStops) {
  Walker walker = walker_along_x(1.37);
  walker.path = {{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, true, 0.5, false};
  walker.stops = {{.at_m = 1.1, .for_s = 1.1},
                  {.at_m = 3.0, .for_s = 4.0, .turn_rad = 1.5},
                  {.at_m = 12.5, .for_s = 2.0}};
  const Gait gait(walker, 0, kLaser_m);
  const double limit_m = kSample_s * ((1.44 + 0.2) / (0.4 * cycle_s(1.37)) + 1.37 + 1.0);
  for (double t_s = 0.0; t_s < 25.0; t_s += kSample_s) {
    const WalkerState a = gait.state_at(t_s);
    const WalkerState b = gait.state_at(t_s + kSample_s);
    ASSERT_LE((b.left_leg_m - a.left_leg_m).norm(), limit_m) << t_s;
    ASSERT_LE((b.right_leg_m - a.right_leg_m).norm(), limit_m) << t_s;
  }
}

}  // namespace
}  // namespace scanbed::sim
