// SPDX-License-Identifier: MIT
#include "sim/planar/ray_caster.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/scan/laser_scan.hpp"
#include "core/scan/truth.hpp"
#include "tests/support/b2_reference_caster.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

// Ranges up to 30 m from a dozen operations in double precision.
constexpr double kRounding_m = 1e-11;

ScanGeometry fan(double first_rad, double step_rad, int num_beams) {
  ScanGeometry geometry;
  geometry.first_rad = first_rad;
  geometry.step_rad = step_rad;
  geometry.num_beams = num_beams;
  return geometry;
}

/// 361 beams all around; the last one looks where the first does.
ScanGeometry full_turn() {
  return fan(-kPi, radians(1.0), 361);
}

PlanarSlice room(const std::vector<Vector2d>& corners_m) {
  PlanarSlice slice;
  for (std::size_t i = 0; i < corners_m.size(); ++i) {
    slice.segments.push_back({corners_m[i], corners_m[(i + 1) % corners_m.size()], static_cast<int>(i)});
  }
  return slice;
}

// ---- closed forms ----

TEST(RayCasterTest, WithoutShapesNothingReturns) {
  RayCaster caster(ScanGeometry{});
  caster.cast({}, {});
  ASSERT_EQ(caster.num_beams(), 361);
  for (int i = 0; i < 361; ++i) {
    EXPECT_EQ(caster.range_m(i), kNoEcho);
    EXPECT_EQ(caster.object(i), kNoObject);
    EXPECT_EQ(caster.incidence_rad(i), 0.0);
  }
}

TEST(RayCasterTest, ASquareRoomIsSeenInEveryDirectionAndAcrossTheSeam) {
  for (const double first_rad : {-kPi, -kPi / 2, 0.0, 2.0, 3.0}) {
    const ScanGeometry geometry = fan(first_rad, radians(1.0), 361);
    RayCaster caster(geometry);
    caster.cast(room({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}), {});
    for (int i = 0; i < caster.num_beams(); ++i) {
      const double cosine =
          std::max(std::abs(std::cos(geometry.bearing_rad(i))), std::abs(std::sin(geometry.bearing_rad(i))));
      EXPECT_NEAR(caster.range_m(i), 2.0 / cosine, kRounding_m) << first_rad << " beam " << i;
      EXPECT_NEAR(std::cos(caster.incidence_rad(i)), cosine, 1e-12);
    }
  }
}

TEST(RayCasterTest, APosedSensorSeesTheRoomFromWhereItIs) {
  RayCaster caster(ScanGeometry{});
  caster.cast(room({{-4, -1}, {6, -1}, {6, 3}, {-4, 3}}), {{1, 0.5}, kPi / 2});  // looks along y
  EXPECT_NEAR(caster.range_m(0), 5.0, kRounding_m);
  EXPECT_EQ(caster.object(0), 1);
  EXPECT_NEAR(caster.range_m(180), 2.5, kRounding_m);
  EXPECT_EQ(caster.object(180), 2);
  EXPECT_NEAR(caster.range_m(360), 5.0, kRounding_m);
  EXPECT_EQ(caster.object(360), 3);
}

TEST(RayCasterTest, ADiscIsMetOnItsFrontByTheBeamsBetweenItsTangents) {
  const ScanGeometry geometry;
  RayCaster caster(geometry);
  PlanarSlice slice;
  slice.discs.push_back({{3, 0}, 0.25, 7});
  caster.cast(slice, {});
  const int half = static_cast<int>(std::asin(0.25 / 3) / geometry.step_rad);
  for (int i = 0; i < 361; ++i) {
    const double bearing_rad = geometry.bearing_rad(i);
    const double beside_m = 3.0 * std::sin(bearing_rad);
    if (std::abs(i - 180) > half) {
      EXPECT_EQ(caster.object(i), kNoObject) << i;
      continue;
    }
    EXPECT_EQ(caster.object(i), 7) << i;
    const double expected_m = 3.0 * std::cos(bearing_rad) - std::sqrt(0.0625 - beside_m * beside_m);
    EXPECT_NEAR(caster.range_m(i), expected_m, kRounding_m) << i;
    EXPECT_NEAR(caster.incidence_rad(i), std::asin(std::abs(beside_m) / 0.25), 1e-9) << i;
  }
}

TEST(RayCasterTest, ADiscAcrossTheSeamIsSeenFromBothEndsOfTheFan) {
  RayCaster caster(full_turn());
  PlanarSlice slice;
  slice.discs.push_back({{-3, 0}, 0.5, 0});
  caster.cast(slice, {});
  const int half = static_cast<int>(std::asin(0.5 / 3) / radians(1.0));
  for (int i = 0; i < 361; ++i) {
    EXPECT_EQ(caster.object(i), i <= half || i >= 360 - half ? 0 : kNoObject) << i;
  }
  EXPECT_NEAR(caster.range_m(0), 2.5, kRounding_m);
  EXPECT_NEAR(caster.range_m(360), 2.5, kRounding_m);
}

TEST(RayCasterTest, TheNearestShapeWinsWhateverTheOrder) {
  PlanarSlice slice;
  slice.segments = {{{5, -9}, {5, 9}, 0}, {{2, -0.5}, {2, 0.5}, 1}, {{4, -9}, {4, 9}, 2}};
  slice.discs = {{{3, 0}, 0.2, 3}, {{1, 3}, 0.2, 4}};
  for (int turn = 0; turn < 3; ++turn) {
    RayCaster caster(ScanGeometry{});
    caster.cast(slice, {});
    EXPECT_EQ(caster.object(180), 1);
    EXPECT_EQ(caster.object(180 + 40), 2);
    EXPECT_EQ(caster.object(180 + 2 * 71), 4);  // atan(3) is 71.6 degrees
    std::rotate(slice.segments.begin(), slice.segments.begin() + 1, slice.segments.end());
    std::reverse(slice.discs.begin(), slice.discs.end());
  }
}

TEST(RayCasterTest, ShapesBehindTheSensorAreNotSeen) {
  PlanarSlice slice;
  slice.segments = {{{-1, -5}, {-1, 5}, 0}};
  slice.discs = {{{-2, 0.5}, 0.3, 1}};
  RayCaster caster(ScanGeometry{});
  caster.cast(slice, {});
  for (int i = 0; i < 361; ++i) EXPECT_EQ(caster.object(i), kNoObject) << i;
}

TEST(RayCasterTest, WallsWithoutWidthAreNotMet) {
  PlanarSlice slice;
  slice.segments = {{{2, 0}, {2, 0}, 0}, {{1, 0}, {3, 0}, 1}, {{0, 0}, {0, 0}, 2}};
  RayCaster caster(ScanGeometry{});
  caster.cast(slice, {});
  for (int i = 0; i < 361; ++i) EXPECT_EQ(caster.object(i), kNoObject) << i;
}

TEST(RayCasterTest, ASensorOnAWallMeetsItAtOnce) {
  PlanarSlice slice;
  slice.segments = {{{0, -2}, {0, 2}, 0}, {{3, -9}, {3, 9}, 1}};
  RayCaster caster(full_turn());
  caster.cast(slice, {});
  for (int i = 0; i < 361; ++i) {
    EXPECT_EQ(caster.range_m(i), 0.0) << i;
    EXPECT_EQ(caster.object(i), 0) << i;
    EXPECT_EQ(caster.incidence_rad(i), 0.0) << i;
  }
}

TEST(RayCasterTest, ASensorAtTheEndOfAWallMeetsItToo) {
  PlanarSlice slice;
  slice.segments = {{{0, 0}, {0, 2}, 0}};
  RayCaster caster(ScanGeometry{});
  caster.cast(slice, {});
  EXPECT_EQ(caster.range_m(180), 0.0);
}

TEST(RayCasterTest, ASensorInADiscSeesItFromInside) {
  PlanarSlice slice;
  slice.discs = {{{0.1, 0}, 0.5, 0}};
  RayCaster caster(full_turn());
  caster.cast(slice, {});
  EXPECT_NEAR(caster.range_m(180), 0.6, kRounding_m);
  EXPECT_NEAR(caster.range_m(0), 0.4, kRounding_m);
  EXPECT_NEAR(caster.range_m(90), std::sqrt(0.25 - 0.01), kRounding_m);
}

TEST(RayCasterTest, TheRotationsOfAScanTogetherAreTheScan) {
  const ScanGeometry geometry;
  const PlanarSlice slice = room({{-4, -1}, {6, -1}, {6, 3}, {-4, 3}});
  RayCaster whole(geometry);
  whole.cast(slice, {{1, 0.5}, 1.0});
  for (const int stride : {2, 4}) {
    int num_beams = 0;
    for (int first = 0; first < stride; ++first) {
      RayCaster part(geometry, {first, stride});
      part.cast(slice, {{1, 0.5}, 1.0});
      num_beams += part.num_beams();
      for (int i = 0; i < part.num_beams(); ++i) {
        EXPECT_EQ(part.range_m(i), whole.range_m(part.scan_beam(i)));
        EXPECT_EQ(part.object(i), whole.object(part.scan_beam(i)));
      }
    }
    EXPECT_EQ(num_beams, 361);
  }
}

TEST(RayCasterTest, FansOfOneBeamAndOfThousandsWork) {
  const PlanarSlice slice = room({{-4, -1}, {6, -1}, {6, 3}, {-4, 3}});
  RayCaster one(fan(0.0, 1.0, 1));
  one.cast(slice, {});
  EXPECT_NEAR(one.range_m(0), 6.0, kRounding_m);
  const ScanGeometry fine = fan(-kPi, 2.0 * kPi / 100000, 100000);
  RayCaster many(fine);
  many.cast(slice, {});
  for (int i = 0; i < many.num_beams(); ++i) {
    const double c = std::cos(fine.bearing_rad(i));
    const double s = std::sin(fine.bearing_rad(i));
    const double expected_m = std::min(c > 0 ? 6.0 / c : -4.0 / c, s > 0 ? 3.0 / s : -1.0 / s);
    ASSERT_NEAR(many.range_m(i), expected_m, 1e-10) << i;
  }
}

TEST(RayCasterTest, ADirectionThatCannotBeAborts) {
  EXPECT_DEATH(RayCaster(fan(0.0, -0.1, 5)), "broken promise");
  EXPECT_DEATH(RayCaster(fan(0.0, 1.0, 9)), "broken promise");
  EXPECT_DEATH(RayCaster(ScanGeometry{}, {0, 0}), "broken promise");
}

// ---- the slow obvious version ----

double meet(const SliceSegment& segment, const Vector2d& from_m, const Vector2d& u) {
  const Vector2d along = segment.b_m - segment.a_m;
  const Vector2d to_a = segment.a_m - from_m;
  const double denominator = u.x() * along.y() - u.y() * along.x();
  if (denominator == 0.0) return kNoEcho;
  const double range_m = (to_a.x() * along.y() - to_a.y() * along.x()) / denominator;
  const double t = (to_a.x() * u.y() - to_a.y() * u.x()) / denominator;
  return range_m >= 0.0 && t >= 0.0 && t <= 1.0 ? range_m : kNoEcho;
}

double meet(const SliceDisc& disc, const Vector2d& from_m, const Vector2d& u) {
  const Vector2d to_c = disc.center_m - from_m;
  const double b = to_c.dot(u);
  const double root = disc.radius_m * disc.radius_m - (to_c - b * u).squaredNorm();
  if (root < 0.0) return kNoEcho;
  if (b - std::sqrt(root) >= 0.0) return b - std::sqrt(root);
  return b + std::sqrt(root) >= 0.0 ? b + std::sqrt(root) : kNoEcho;
}

/// Nearest return of one ray; of one object alone where `only` is not kNoObject.
double slow_cast(const PlanarSlice& slice, const Vector2d& from_m, double bearing_W_rad,
                 int only = kNoObject) {
  const Vector2d u(std::cos(bearing_W_rad), std::sin(bearing_W_rad));
  double nearest_m = kNoEcho;
  const auto look_at = [&](const auto& shapes) {
    for (const auto& shape : shapes) {
      if (only == kNoObject || shape.object == only) nearest_m = std::min(nearest_m, meet(shape, from_m, u));
    }
  };
  look_at(slice.segments);
  look_at(slice.discs);
  return nearest_m;
}

bool same_range(double a_m, double b_m) {
  return a_m == b_m || std::abs(a_m - b_m) <= 1e-6;
}

/// A random world on a grid of centimetres: walls that touch, cross and coincide, some of length 0, and
/// discs. One sensor in four stands on a corner's height, so that walls point at it.
struct RandomWorld {
  PlanarSlice slice;
  Pose2 X_WS;
  ScanGeometry geometry;
};

RandomWorld random_world() {
  const auto place = [] {
    const double x_m = *rc::gen::inRange(-1000, 1001) / 100.0;
    const double y_m = *rc::gen::inRange(-1000, 1001) / 100.0;
    return Vector2d(x_m, y_m);
  };
  RandomWorld world;
  Vector2d last = place();
  const int num_segments = *rc::gen::inRange(0, 16);
  for (int i = 0; i < num_segments; ++i) {
    const Vector2d next = place();
    world.slice.segments.push_back({last, next, i});
    last = *rc::gen::weightedElement<int>({{3, 0}, {1, 1}}) == 0 ? next : place();
  }
  const int num_discs = *rc::gen::inRange(0, 8);
  for (int i = 0; i < num_discs; ++i) {
    world.slice.discs.push_back({place(), *rc::gen::inRange(3, 120) / 100.0, num_segments + i});
  }
  world.X_WS = {place(), *rc::gen::inRange(-180, 181) * kPi / 180};
  world.geometry = *rc::gen::element(ScanGeometry{}, full_turn(), fan(2.5, radians(0.25), 401),
                                     fan(-3.0, radians(7.0), 40), fan(1.0, radians(0.05), 20));
  return world;
}

double distance_to_surface_m(const PlanarSlice& slice, const Vector2d& p) {
  double nearest_m = kNoEcho;
  for (const SliceSegment& s : slice.segments) {
    const Vector2d along = s.b_m - s.a_m;
    const double length_sq = along.squaredNorm();
    const double t = length_sq > 0 ? std::clamp((p - s.a_m).dot(along) / length_sq, 0.0, 1.0) : 0.0;
    nearest_m = std::min(nearest_m, (p - s.a_m - t * along).norm());
  }
  for (const SliceDisc& d : slice.discs) {
    nearest_m = std::min(nearest_m, std::abs((p - d.center_m).norm() - d.radius_m));
  }
  return nearest_m;
}

// A beam that just touches a corner may meet it or not: the answer has to be that of a ray turned by -1e-9, 0
// or 1e-9 rad. (30 m x 1e-9 / cos 88.9 deg stays below same_range's micrometre; flatter beams are left out.)
RC_GTEST_PROP(RayCasterTest, AgreesWithTheSlowObviousVersion, ()) {
  const RandomWorld world = random_world();
  RC_PRE(distance_to_surface_m(world.slice, world.X_WS.p_m) > 1e-9);
  RayCaster caster(world.geometry);
  caster.cast(world.slice, world.X_WS);
  for (int i = 0; i < caster.num_beams(); ++i) {
    if (caster.object(i) != kNoObject && std::cos(caster.incidence_rad(i)) < 0.02) continue;
    const double bearing_W_rad = world.X_WS.theta_rad + world.geometry.bearing_rad(i);
    bool agrees = false;
    for (const double turn_rad : {0.0, -1e-9, 1e-9}) {
      const double expected_m = slow_cast(world.slice, world.X_WS.p_m, bearing_W_rad + turn_rad);
      const double alone_m =
          slow_cast(world.slice, world.X_WS.p_m, bearing_W_rad + turn_rad, caster.object(i));
      agrees = agrees || (same_range(caster.range_m(i), expected_m) && same_range(alone_m, expected_m));
    }
    if (!agrees) RC_LOG() << "beam " << i << " range " << caster.range_m(i) << " object " << caster.object(i);
    RC_ASSERT(agrees);
  }
}

// Whatever is round it: to one side at least the wall is met at once, to the other beams may leave it (it is
// then a rounding away) and meet what they would without it.
RC_GTEST_PROP(RayCasterTest, OnAWallEveryBeamMeetsItOrWhatLiesBehind, ()) {
  RandomWorld world = random_world();
  RC_PRE(!world.slice.segments.empty());
  const std::size_t on = *rc::gen::inRange<std::size_t>(0, world.slice.segments.size());
  const SliceSegment wall = world.slice.segments[on];
  RC_PRE((wall.b_m - wall.a_m).norm() > 0.1);
  world.X_WS.p_m = wall.a_m + *rc::gen::inRange(1, 100) / 100.0 * (wall.b_m - wall.a_m);
  PlanarSlice others = world.slice;
  others.segments.erase(others.segments.begin() + static_cast<std::ptrdiff_t>(on));
  RC_PRE(distance_to_surface_m(others, world.X_WS.p_m) > 1e-6);
  world.geometry = full_turn();
  RayCaster caster(world.geometry);
  caster.cast(world.slice, world.X_WS);
  int num_at_once = 0;
  for (int i = 0; i < caster.num_beams(); ++i) {
    if (caster.range_m(i) < 1e-9 && caster.object(i) == wall.object) {
      ++num_at_once;
      continue;
    }
    if (caster.object(i) == wall.object) continue;  // along the wall
    if (caster.object(i) != kNoObject && std::cos(caster.incidence_rad(i)) < 0.02) continue;
    const double bearing_W_rad = world.X_WS.theta_rad + world.geometry.bearing_rad(i);
    bool agrees = false;
    for (const double turn_rad : {0.0, -1e-9, 1e-9}) {
      const double expected_m = slow_cast(others, world.X_WS.p_m, bearing_W_rad + turn_rad);
      agrees = agrees || same_range(caster.range_m(i), expected_m);
    }
    RC_ASSERT(agrees);
  }
  RC_ASSERT(num_at_once >= caster.num_beams() / 2 - 2);
}

constexpr double kMinCosine = 0.02;  // beams that graze more are not compared with Box2D's

/// The same world with every surface a little smaller or larger.
PlanarSlice resized(const PlanarSlice& slice, const Vector2d& from_m, double sign) {
  // Box2D counts in floats: 24 bits. Places within 14 m of the origin are off by up to 14 m / 2^24 = 8e-7 m;
  // a wall may end beside a beam by that much, times a few operations; along the wall that is the more, the
  // more the beam grazes it.
  constexpr double kPlace_m = 1e-5;
  // For a disc at distance D it takes the difference of two squares of size D^2, each off by a few times
  // D^2 / 2^24: that is by how much the squared radius is uncertain.
  constexpr double kFloat = 0x1p-24;
  PlanarSlice other = slice;
  for (SliceSegment& s : other.segments) {
    const Vector2d along = (s.b_m - s.a_m).normalized();
    const auto place_along_m = [&](const Vector2d& end_m) {
      const Vector2d u = (end_m - from_m).normalized();
      return kPlace_m / std::max(kMinCosine, std::abs(u.x() * along.y() - u.y() * along.x()));
    };
    if ((s.b_m - s.a_m).norm() <= 2.0 * kPlace_m / kMinCosine) continue;
    s.a_m -= sign * place_along_m(s.a_m) * along;
    s.b_m += sign * place_along_m(s.b_m) * along;
  }
  for (SliceDisc& d : other.discs) {
    const double squared = 8.0 * kFloat * (d.center_m - from_m).squaredNorm() + 2.0 * d.radius_m * kPlace_m;
    d.radius_m = std::sqrt(std::max(1e-12, d.radius_m * d.radius_m + sign * squared));
  }
  return other;
}

RC_GTEST_PROP(RayCasterTest, AgreesWithBox2DsRayCast, ()) {
  const RandomWorld world = random_world();
  for (const SliceDisc& d : world.slice.discs) {
    RC_PRE((d.center_m - world.X_WS.p_m).norm() > d.radius_m + 0.01);  // Box2D sees no disc from inside
  }
  RC_PRE(distance_to_surface_m(world.slice, world.X_WS.p_m) > 0.01);
  const test::B2ReferenceCaster reference(world.slice);
  RayCaster larger(world.geometry);
  RayCaster smaller(world.geometry);
  larger.cast(resized(world.slice, world.X_WS.p_m, 1.0), world.X_WS);
  smaller.cast(resized(world.slice, world.X_WS.p_m, -1.0), world.X_WS);
  for (int i = 0; i < larger.num_beams(); ++i) {
    const double bearing_W_rad = world.X_WS.theta_rad + world.geometry.bearing_rad(i);
    const Vector2d u(std::cos(bearing_W_rad), std::sin(bearing_W_rad));
    const double cosine = std::min(std::cos(larger.incidence_rad(i)), std::cos(smaller.incidence_rad(i)));
    if (cosine < kMinCosine) continue;
    const double range_m = reference.cast(world.X_WS.p_m, u, 50.0).range_m;
    const double tolerance_m = 1e-5 / cosine;  // kPlace_m across the surface, seen along the beam
    if (range_m < larger.range_m(i) - tolerance_m || range_m > smaller.range_m(i) + tolerance_m) {
      RC_LOG() << "beam " << i << ": " << range_m << " not in " << larger.range_m(i) << " .. "
               << smaller.range_m(i) << " tolerance " << tolerance_m;
      RC_FAIL("Box2D disagrees");
    }
  }
}

// Star-shaped rooms round the sensor, with corners straight on beams: no beam may slip through between two
// walls.
RC_GTEST_PROP(RayCasterTest, NoBeamLeavesAClosedRoom, ()) {
  const int num_corners = *rc::gen::inRange(3, 40);
  const double theta_rad = *rc::gen::inRange(-180, 181) * kPi / 180;
  const Vector2d center(*rc::gen::inRange(-500, 501) / 100.0, *rc::gen::inRange(-500, 501) / 100.0);
  std::vector<Vector2d> corners;
  for (int i = 0; i < num_corners; ++i) {
    const double angle_rad = radians(std::floor(360.0 * i / num_corners));
    const double radius_m = *rc::gen::inRange(50, 900) / 100.0;
    corners.push_back(center + radius_m * Vector2d(std::cos(angle_rad), std::sin(angle_rad)));
  }
  RayCaster caster(full_turn());
  caster.cast(room(corners), {center, theta_rad});
  for (int i = 0; i < caster.num_beams(); ++i) RC_ASSERT(caster.range_m(i) < 9.0 + 1e-9);
}

}  // namespace
}  // namespace scanbed::sim
