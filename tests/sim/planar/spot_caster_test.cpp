// SPDX-License-Identifier: MIT
#include "sim/planar/spot_caster.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/scan/laser_scan.hpp"
#include "tests/sim/planar/lms_spot.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;
using testing::kLmsSpot;

// 30 degrees to either side; beam 60 looks straight ahead.
const ScanGeometry kAhead{.num_beams = 121, .first_rad = radians(-30.0)};

IdealReturns cast(const PlanarSlice& slice, const Pose2& X_LS, const ScanGeometry& geometry,
                  const Spot& spot = kLmsSpot, BeamSubset subset = {}) {
  RayCaster axes(geometry, subset);
  SpotCaster spots(geometry, subset, spot);
  axes.cast(slice, X_LS);
  IdealReturns returns;
  returns.reset(geometry.num_beams);
  returns.take_axes(axes);
  spots.cast(slice, X_LS, axes, returns);
  return returns;
}

/// What one ray meets, by solving for each shape in turn.
SpotReturn slow_ray(const PlanarSlice& slice, const Vector2d& p_LO, const Vector2d& u) {
  SpotReturn nearest{.range_m = kNoEcho};
  const auto keep = [&](double range_m, int object) {
    if (range_m > 0.0 && range_m < nearest.range_m) nearest = {0.0, range_m, 1.0, object};
  };
  for (const SliceSegment& s : slice.segments) {
    Eigen::Matrix2d system;
    system << u, s.a_m - s.b_m;
    const Vector2d solution = system.inverse() * (s.a_m - p_LO);
    if (solution.y() >= 0.0 && solution.y() <= 1.0) keep(solution.x(), s.object);
  }
  for (const SliceDisc& d : slice.discs) {
    const Vector2d way = p_LO - d.center_m;
    const double half_b = way.dot(u);
    const double discriminant = half_b * half_b - way.squaredNorm() + d.radius_m * d.radius_m;
    if (discriminant >= 0.0) keep(-half_b - std::sqrt(discriminant), d.object);
  }
  return nearest;
}

std::vector<SpotReturn> slow_spot(const PlanarSlice& slice, const Pose2& X_LS, double bearing_rad,
                                  const Spot& spot) {
  std::vector<SpotReturn> rays;
  for (int k = 0; k < spot.num_rays; ++k) {
    const double share = 2.0 * k / (spot.num_rays - 1) - 1.0;
    const double axis_rad = X_LS.theta_rad + bearing_rad;
    const double ray_rad = axis_rad + 0.5 * share * spot.divergence_rad;
    const Vector2d p_LO =
        X_LS.p_m + 0.5 * share * spot.diameter_m * Vector2d(-std::sin(axis_rad), std::cos(axis_rad));
    rays.push_back(slow_ray(slice, p_LO, {std::cos(ray_rad), std::sin(ray_rad)}));
  }
  return rays;
}

// The near wall's right end lies on the axis of the middle beam: the left half of the spot and its middle ray
// meet it, the rest a wall behind.
TEST(SpotCasterTest, AnEdgeOnTheAxisSplitsTheSpotInHalves) {
  PlanarSlice slice;
  slice.segments = {{{4, 0}, {4, 3}, 0}, {{6, -5}, {6, 5}, 1}};
  const IdealReturns returns = cast(slice, {}, kAhead);
  ASSERT_EQ(returns.split_spots.size(), 1U);
  const SplitSpot& spot = returns.split_spots[0];
  EXPECT_EQ(spot.beam, 60);
  ASSERT_EQ(spot.count, 7);
  double weight = 0.0;
  for (int k = 0; k < 7; ++k) {
    const SpotReturn& ray = returns.spot_returns[spot.first + k];
    weight += ray.weight;
    if (k != 3) {  // the middle one runs along the edge
      EXPECT_EQ(ray.object, k < 3 ? 1 : 0) << k;
      EXPECT_NEAR(ray.range_m, (k < 3 ? 6.0 : 4.0) / std::cos((k - 3) / 3.0 * 0.0022), 1e-12);
      EXPECT_NEAR(ray.weight, returns.spot_returns[spot.first + 6 - k].weight, 1e-15);
    }
  }
  EXPECT_NEAR(weight, 1.0, 1e-12);
  // Brightness of a Gaussian disc at its rim: 1 / e^2 of the middle's.
  EXPECT_NEAR(returns.spot_returns[0].weight / returns.spot_returns[3].weight, std::exp(-2.0), 1e-12);
}

TEST(SpotCasterTest, SmoothSurfacesAreNotSplit) {
  PlanarSlice slice;
  slice.segments = {{{4, -30}, {4, 30}, 0}};
  EXPECT_TRUE(cast(slice, {}, kAhead).split_spots.empty());
  slice = {};
  slice.discs = {{{0.2, 0.1}, 1.5, 0}};  // from inside
  EXPECT_TRUE(cast(slice, {}, kAhead).split_spots.empty());
  EXPECT_TRUE(cast({}, {}, kAhead).split_spots.empty());
}

TEST(SpotCasterTest, EdgesBehindASurfaceAreNotSplit) {
  PlanarSlice slice;
  slice.segments = {{{2, -30}, {2, 30}, 0}, {{4, 0}, {4, 3}, 1}};
  EXPECT_TRUE(cast(slice, {}, ScanGeometry{}).split_spots.empty());
}

TEST(SpotCasterTest, AThinPostBetweenTwoAxesIsMetByTheirSpots) {
  PlanarSlice slice;
  const double between_rad = radians(0.2);  // axes at 0 and 0.5 degrees; the spot at 2 m is 0.65 degrees wide
  slice.discs = {{2.0 * Vector2d(std::cos(between_rad), std::sin(between_rad)), 0.001, 5}};
  const IdealReturns returns = cast(slice, {}, ScanGeometry{});
  EXPECT_EQ(returns.object[180], kNoObject);
  ASSERT_FALSE(returns.split_spots.empty());
  for (const SplitSpot& spot : returns.split_spots) EXPECT_TRUE(spot.beam == 180 || spot.beam == 181);
}

TEST(SpotCasterTest, OneRayAtTheAxisSplitsNothing) {
  PlanarSlice slice;
  slice.segments = {{{4, 0.001}, {4, 3}, 0}};
  EXPECT_TRUE(cast(slice, {}, ScanGeometry{}, {0.014, 0.0044, 1}).split_spots.empty());
}

// An edge falls anywhere between two axes, which are range x step apart; it is in a spot with probability
// diameter / (range x step): 0.905 at 4 m. The published figure is "about 90 %".
TEST(SpotCasterTest, TheShareOfSilhouettesWithAMixedBeamIsSpotOverBeamSpacing) {
  for (const double range_m : {4.0, 5.0, 6.0, 8.0}) {
    constexpr int kNum = 2000;
    int num_mixed = 0;
    for (int k = 0; k < kNum; ++k) {
      const double bearing_rad = (k + 0.5) / kNum * radians(0.5);
      const Vector2d p_LA = range_m * Vector2d(std::cos(bearing_rad), std::sin(bearing_rad));
      PlanarSlice slice;
      slice.segments = {{p_LA, p_LA + Vector2d(0, 3), 0}};
      const IdealReturns returns = cast(slice, {}, {.num_beams = 5, .first_rad = radians(-1.0)});
      num_mixed +=
          std::any_of(returns.split_spots.begin(), returns.split_spots.end(), [&](const SplitSpot& s) {
            return s.beam == 2 || s.beam == 3;  // the two that it lies between
          });
    }
    const double expected = std::min(1.0, (0.014 + 0.0044 * range_m) / (range_m * radians(0.5)));
    EXPECT_NEAR(static_cast<double>(num_mixed) / kNum, expected, 0.003)
        << range_m;  // a few steps of the sweep
  }
}

/// Discs and short walls on a grid, none touching another, around a laser.
PlanarSlice random_slice() {
  PlanarSlice slice;
  for (int x = -4; x <= 4; ++x) {
    for (int y = -4; y <= 4; ++y) {
      if (std::abs(x) <= 1 && std::abs(y) <= 1) continue;
      const auto part = [] { return *rc::gen::inRange(0, 1000) * 1e-3; };
      if (part() < 0.5) continue;
      const Vector2d center(x + 0.3 * part(), y + 0.3 * part());
      const int object = static_cast<int>(slice.discs.size() + slice.segments.size());
      if (part() < 0.5) {
        slice.discs.push_back({center, 0.01 + 0.25 * part(), object});
      } else {
        const double angle_rad = 2.0 * kPi * part();
        slice.segments.push_back(
            {center, center + (0.05 + 0.25 * part()) * Vector2d(std::cos(angle_rad), std::sin(angle_rad)),
             object});
      }
    }
  }
  return slice;
}

RC_GTEST_PROP(SpotCasterTest, SplitsJustTheSpotsThatASlowSearchFindsInRandomWorlds, ()) {
  const PlanarSlice slice = random_slice();
  const Pose2 X_LS{{0.37e-3 * *rc::gen::inRange(0, 1000), 0.11}, *rc::gen::inRange(-3140, 3140) * 1e-3};
  const bool full_turn = *rc::gen::arbitrary<bool>();
  ScanGeometry geometry{.num_beams = 361};
  if (full_turn) geometry = {.num_beams = 720, .first_rad = -kPi, .step_rad = kPi / 360};
  const BeamSubset subset = *rc::gen::element(BeamSubset{}, BeamSubset{1, 2}, BeamSubset{40, 1, 100});
  const IdealReturns returns = cast(slice, X_LS, geometry, kLmsSpot, subset);
  std::vector<int> split_of_beam(geometry.num_beams, -1);
  for (std::size_t i = 0; i < returns.split_spots.size(); ++i)
    split_of_beam[returns.split_spots[i].beam] = static_cast<int>(i);
  int seen = 0;
  for (int beam = subset.first; beam < geometry.num_beams && seen < subset.count;
       beam += subset.stride, ++seen) {
    const std::vector<SpotReturn> slow = slow_spot(slice, X_LS, geometry.bearing_rad(beam), kLmsSpot);
    const bool is_mixed = std::any_of(slow.begin(), slow.end(),
                                      [&](const SpotReturn& r) { return r.object != slow[0].object; });
    RC_ASSERT(is_mixed == (split_of_beam[beam] >= 0));
    if (!is_mixed) continue;
    for (int k = 0; k < 7; ++k) {
      const SpotReturn& ray = returns.spot_returns[returns.split_spots[split_of_beam[beam]].first + k];
      RC_ASSERT(ray.object == slow[k].object);
      if (ray.object != kNoObject) RC_ASSERT(std::abs(ray.range_m - slow[k].range_m) < 1e-6);
    }
  }
}

// The same thing as a disc and as a conic.
TEST(SpotCasterTest, AnArcSplitsTheBeamsThatADiscSplits) {
  PlanarSlice discs;
  discs.segments.push_back({{5, -5}, {5, 5}, 0});
  discs.discs.push_back({{3.0, 0.4}, 0.25, 1});
  PlanarSlice arcs;
  arcs.segments = discs.segments;
  SliceArc& circle = arcs.arcs.emplace_back();
  circle.center_m = {3.0, 0.4};
  circle.level = circle.normal = 0.25;
  circle.level *= 0.25;
  circle.object = 1;
  const IdealReturns of_disc = cast(discs, {}, kAhead);
  const IdealReturns of_arc = cast(arcs, {}, kAhead);
  ASSERT_GT(of_disc.split_spots.size(), 0U);
  ASSERT_EQ(of_arc.split_spots.size(), of_disc.split_spots.size());
  ASSERT_EQ(of_arc.spot_returns.size(), of_disc.spot_returns.size());
  for (std::size_t i = 0; i < of_disc.split_spots.size(); ++i) {
    EXPECT_EQ(of_arc.split_spots[i].beam, of_disc.split_spots[i].beam);
  }
  for (std::size_t i = 0; i < of_disc.spot_returns.size(); ++i) {
    EXPECT_EQ(of_arc.spot_returns[i].object, of_disc.spot_returns[i].object) << i;
    EXPECT_NEAR(of_arc.spot_returns[i].range_m, of_disc.spot_returns[i].range_m, 1e-9) << i;
    EXPECT_NEAR(of_arc.spot_returns[i].cos_incidence, of_disc.spot_returns[i].cos_incidence, 1e-6) << i;
  }
}

}  // namespace
}  // namespace scanbed::sim
