// SPDX-License-Identifier: MIT
#include "core/track/gait_expectation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace scanbed {
namespace {

using Eigen::Vector2d;

// At the origin, exactly known, on the way along x.
LiveTrack walker(double speed_m_per_s) {
  LiveTrack person;
  person.kind = TrackKind::kPerson;
  person.point.v_m_per_s = {speed_m_per_s, 0.0};
  return person;
}

LiveTrack with_legs_at(LiveTrack person, const Vector2d& a_m, const Vector2d& b_m, double unseen_s) {
  person.p_WL_m = {a_m, b_m};
  person.num_legs_seen = 2;
  person.unseen_s = unseen_s;
  return person;
}

TEST(GaitExpectationTest, ALegAtTheMiddleOfWhoIsExactlyKnownIsNoSurprise) {
  EXPECT_NEAR(GaitExpectation(walker(0.0)).surprise_of(Vector2d::Zero()), 0.0, 1e-9);
}

// -2 ln of a Gaussian with 0.18 m: one more for each standard deviation, squared.
TEST(GaitExpectationTest, WithoutLegsSeenBeforeDistanceFromTheMiddleCounts) {
  const GaitExpectation expectation(walker(1.3));
  EXPECT_NEAR(expectation.surprise_of(Vector2d(0.18, 0.0)), 1.0, 1e-6);
  EXPECT_NEAR(expectation.surprise_of(Vector2d(0.0, 0.36)), 4.0, 1e-6);
}

// One foot stands for 0.63 s of 1.05 s: 0.2 s after, at least one has stood all the time in 0.86 of 1.05 s.
// Its shin went on by 0.35 of the way of 0.26 m; that leg's own Gaussian has 0.03 m and 0.12 of the way.
TEST(GaitExpectationTest, ALegThatStandsIsWhereItWas) {
  const LiveTrack person = with_legs_at(walker(1.3), {0.2, 0.1}, {-0.2, -0.1}, 0.2);
  const double var_m2 = 0.03 * 0.03 + 0.0312 * 0.0312;
  const double standing = 0.5 * 0.86 / 1.05;
  const Vector2d at_m(0.2 + 0.35 * 0.26, 0.1);
  const double likelihood =
      standing * 0.0324 / var_m2 + (1.0 - standing) * std::exp(-0.5 * at_m.squaredNorm() / 0.0324);
  EXPECT_NEAR(GaitExpectation(person).surprise_of(at_m), -2.0 * std::log(likelihood), 1e-6);
}

TEST(GaitExpectationTest, AfterAStepNoFootHasStoodAllTheTime) {
  const LiveTrack before = with_legs_at(walker(1.3), {0.2, 0.1}, {-0.2, -0.1}, 0.7);
  const Vector2d at_m(0.3, 0.1);
  EXPECT_NEAR(GaitExpectation(before).surprise_of(at_m), GaitExpectation(walker(1.3)).surprise_of(at_m),
              1e-9);
}

TEST(GaitExpectationTest, LegsLieAlongTheWayRatherThanAcross) {
  const GaitExpectation expectation(walker(1.3));
  const double along = expectation.surprise_of(Vector2d(0.2, 0.0), Vector2d(-0.2, 0.0));
  const double across = expectation.surprise_of(Vector2d(0.0, 0.2), Vector2d(0.0, -0.2));
  // 0.4 m are 0.4 / 0.38 standard deviations along; across they are 0.4 / 0.20 where the heading is certain,
  // and it is so by 1.69 / (1.69 + 0.09).
  const double sureness = 1.69 / 1.78;
  const double across_var_m2 = sureness * 0.20 * 0.20 + (1.0 - sureness) * 0.38 * 0.38;
  EXPECT_NEAR(across - along, 0.16 / across_var_m2 - 0.16 / (0.38 * 0.38), 1e-9);
}

TEST(GaitExpectationTest, WhoStandsHasLegsInAnyDirection) {
  const GaitExpectation expectation(walker(0.0));
  EXPECT_NEAR(expectation.surprise_of(Vector2d(0.15, 0.0), Vector2d(-0.15, 0.0)),
              expectation.surprise_of(Vector2d(0.0, 0.15), Vector2d(0.0, -0.15)), 1e-9);
}

// Two stand side by side, one's left leg 0.4 m from the other's right one: that is no pair of legs that were
// seen 0.2 m apart just before.
TEST(GaitExpectationTest, APairKeepsToItsPlaces) {
  const LiveTrack person = with_legs_at(walker(0.0), {0.0, 0.1}, {0.0, -0.1}, 0.2);
  const GaitExpectation expectation(person);
  const double own = expectation.surprise_of(Vector2d(0.0, 0.1), Vector2d(0.0, -0.1));
  const double mixed = expectation.surprise_of(Vector2d(0.0, -0.1), Vector2d(0.0, -0.5));
  EXPECT_GT(mixed, own + 4.0);  // the middle alone is 0.3 m off
  EXPECT_NEAR(expectation.surprise_of(Vector2d(0.0, -0.1), Vector2d(0.0, 0.1)), own, 1e-9);
}

// In 0.2 s a shin swings by 2.05 * 0.26 m, and 0.1 m more is no surprise; 0.1 m beyond that is 1, up to
// 8. Legs that were not both seen tell nothing of it: the difference is all there is between the two.
TEST(GaitExpectationTest, NoLegGoesFarBeyondASwing) {
  const Vector2d foot_m(0.0, 0.1);
  const Vector2d other_m(0.0, -0.1);
  const LiveTrack both = with_legs_at(walker(1.3), foot_m, other_m, 0.2);
  LiveTrack one = both;
  one.num_legs_seen = 1;
  const double reach_m = 0.1 + 2.05 * 0.26;
  for (const auto& [beyond_m, haste] : {std::pair{-0.1, 0.0}, {0.1, 1.0}, {0.2, 4.0}, {0.5, 8.0}}) {
    const Vector2d at_m(reach_m + beyond_m, -0.1);
    const Vector2d standing_m(0.35 * 0.26, 0.1);
    EXPECT_NEAR(GaitExpectation(both).surprise_of(standing_m, at_m) -
                    GaitExpectation(one).surprise_of(standing_m, at_m),
                haste, 1e-9);
  }
}

TEST(GaitExpectationTest, WhoIsLessKnownIsLessSureOfALegAndLessSurprisedFarOff) {
  LiveTrack person = walker(1.3);
  const GaitExpectation known(person);
  person.point.var_p_m2 = 0.25;
  const GaitExpectation unknown(person);
  EXPECT_GT(unknown.surprise_of(Vector2d(0.1, 0.0)), known.surprise_of(Vector2d(0.1, 0.0)));
  EXPECT_LT(unknown.surprise_of(Vector2d(1.0, 0.0)), known.surprise_of(Vector2d(1.0, 0.0)));
}

}  // namespace
}  // namespace scanbed
