// SPDX-License-Identifier: MIT
#include "sim/planar/arc_in_beams.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <cmath>

#include "sim/planar/ray_caster.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

Vector2d direction(double bearing_rad) {
  return {std::cos(bearing_rad), std::sin(bearing_rad)};
}

// x^2 / a^2 + y^2 / b^2 = 1 about the centre.
SliceArc ellipse(const Vector2d& center_m, double a_m, double b_m) {
  SliceArc arc;
  arc.center_m = center_m;
  arc.form = Vector2d(1.0 / (a_m * a_m), 1.0 / (b_m * b_m)).asDiagonal();
  arc.level = 1.0;
  return arc;
}

TEST(ArcInBeamsTest, AnEllipseIsMetAtItsNearVertex) {
  const ArcInBeams arc(ellipse({5, 0}, 2, 1), {});
  EXPECT_NEAR(1.0 / arc.inverse_range({1, 0}), 3.0, 1e-12);
  EXPECT_NEAR(arc.cos_incidence({1, 0}, 1.0 / 3.0), 1.0, 1e-12);
  EXPECT_EQ(arc.inverse_range({-1, 0}), 0.0);
  EXPECT_EQ(arc.inverse_range({0, 1}), 0.0);
}

TEST(ArcInBeamsTest, ASensorThatIsTurnedAndMovedSeesTheSame) {
  const Pose2 X_LS{{5, -4}, kPi / 2};  // looks along the short axis
  const ArcInBeams arc(ellipse({5, 0}, 2, 1), X_LS);
  EXPECT_NEAR(1.0 / arc.inverse_range({1, 0}), 3.0, 1e-12);
}

TEST(ArcInBeamsTest, BehindTheMissingPieceTheFarSideShows) {
  SliceArc far_half = ellipse({5, 0}, 2, 1);
  far_half.along = {1, 0};
  far_half.from = 0.0;
  EXPECT_NEAR(1.0 / ArcInBeams(far_half, {}).inverse_range({1, 0}), 7.0, 1e-12);
  far_half.from = 2.5;
  EXPECT_EQ(ArcInBeams(far_half, {}).inverse_range({1, 0}), 0.0);
}

TEST(ArcInBeamsTest, FromInsideTheWayOutIsMetInEveryDirection) {
  const ArcInBeams arc(ellipse({0, 0}, 2, 1), {});
  EXPECT_FALSE(arc.wedge());
  EXPECT_NEAR(1.0 / arc.inverse_range({1, 0}), 2.0, 1e-12);
  EXPECT_NEAR(1.0 / arc.inverse_range({-1, 0}), 2.0, 1e-12);
  EXPECT_NEAR(1.0 / arc.inverse_range({0, -1}), 1.0, 1e-12);
}

// A cylinder that lies along y in the laser's plane: two parallel lines.
TEST(ArcInBeamsTest, TwoParallelLinesAreAConicToo) {
  SliceArc lines;
  lines.center_m = {4, 0};
  lines.form << 1, 0, 0, 0;
  lines.level = 0.25;
  const ArcInBeams arc(lines, {});
  EXPECT_FALSE(arc.wedge());
  for (const double bearing_rad : {-1.2, 0.0, 0.7}) {
    EXPECT_NEAR(1.0 / arc.inverse_range(direction(bearing_rad)), 3.5 / std::cos(bearing_rad), 1e-12);
  }
  EXPECT_EQ(arc.inverse_range({0, 1}), 0.0);
}

TEST(ArcInBeamsTest, ACircleIsMetAsADiscIs) {
  PlanarSlice as_disc;
  as_disc.discs.push_back({{2.0, 1.0}, 0.25, 7});
  PlanarSlice as_arc;
  as_arc.arcs.push_back(ellipse({2.0, 1.0}, 0.25, 0.25));
  as_arc.arcs[0].object = 7;
  RayCaster disc{ScanGeometry{}};
  RayCaster arc{ScanGeometry{}};
  const Pose2 X_LS{{0.3, -0.2}, 0.4};
  disc.cast(as_disc, X_LS);
  arc.cast(as_arc, X_LS);
  int num_met = 0;
  for (int i = 0; i < disc.num_beams(); ++i) {
    ASSERT_EQ(arc.object(i), disc.object(i)) << i;
    if (disc.object(i) != 7) continue;
    ++num_met;
    EXPECT_NEAR(arc.range_m(i), disc.range_m(i), 1e-9) << i;
    EXPECT_NEAR(arc.incidence_rad(i), disc.incidence_rad(i), 1e-6) << i;
  }
  // 2 asin(r / d) wide, in steps of half a degree.
  EXPECT_NEAR(num_met, 2.0 * std::asin(0.25 / std::hypot(1.7, 1.2)) / radians(0.5), 1.0);
}

TEST(ArcInBeamsTest, SeenFromElsewhereItIsWhereItWas) {
  SliceArc half = ellipse({5, 1}, 2, 1);
  half.along = {0.3, 1};
  half.from = -0.2;
  const Vector2d p_SO(0.4, -0.7);
  const ArcInBeams moved = ArcInBeams(half, {}).seen_from(p_SO);
  const ArcInBeams there(half, {p_SO, 0.0});
  for (int i = 0; i < 100; ++i) {
    const Vector2d u = direction(0.02 * i - 1.0);
    EXPECT_NEAR(moved.inverse_range(u), there.inverse_range(u), 1e-12) << i;
  }
}

// A circle of radius r at distance d is touched at distance sqrt(d^2 - r^2).
TEST(ArcInBeamsTest, TangentsTouchWhereTheyShould) {
  const ArcInBeams arc(ellipse({4, 3}, 1, 1), {});
  const auto wedge = arc.wedge();
  ASSERT_TRUE(wedge);
  for (const Vector2d& side : {wedge->right, wedge->left}) {
    const Vector2d touch_m = arc.touch_m(side);
    EXPECT_NEAR(touch_m.norm(), std::sqrt(24.0), 1e-9);
    EXPECT_NEAR((touch_m - Vector2d(4, 3)).norm(), 1.0, 1e-9);
  }
}

// Between the tangents, and only there, the beams meet it; and where they do, the point is on the ellipse.
TEST(ArcInBeamsTest, TheWedgeIsWhereItIsMet) {
  rc::check([] {
    const auto number = [](int least, int most) { return 0.01 * *rc::gen::inRange(least, most); };
    SliceArc given = ellipse({number(-500, 500), number(-500, 500)}, number(5, 200), number(5, 200));
    const Eigen::Rotation2Dd turn(number(-314, 314));
    given.form = turn.toRotationMatrix() * given.form * turn.toRotationMatrix().transpose();
    const ArcInBeams arc(given, {});
    const auto wedge = arc.wedge();
    if (!wedge) return;
    const double right_rad = std::atan2(wedge->right.y(), wedge->right.x());
    double width_rad = std::atan2(wedge->left.y(), wedge->left.x()) - right_rad;
    if (width_rad < 0.0) width_rad += 2.0 * kPi;
    RC_ASSERT(width_rad <= kPi);
    for (int i = 0; i < 360; ++i) {
      const double from_right_rad = (i + 0.5) / 360.0 * 2.0 * kPi;
      if (std::abs(from_right_rad - width_rad) < 1e-6) continue;
      const Vector2d u = direction(right_rad + from_right_rad);
      const double inverse = arc.inverse_range(u);
      RC_ASSERT((inverse > 0.0) == (from_right_rad < width_rad));
      if (inverse == 0.0) continue;
      const Vector2d q = u / inverse - given.center_m;
      RC_ASSERT(std::abs(q.dot(given.form * q) - 1.0) < 1e-6);
    }
  });
}

}  // namespace
}  // namespace scanbed::sim
