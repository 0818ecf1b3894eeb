// SPDX-License-Identifier: MIT
#include "sim/sensor/simulated_lms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <string>

#include "core/errors/input_error.hpp"
#include "sim/sensor/sensor_presets.hpp"
#include "sim/world/gait.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr RangeSensor::Seconds kNoWait{0.0};

// The laser stands at (0, 1) and looks along y at a wall 3 m ahead, 40 m wide.
World wall_ahead() {
  World world;
  world.solids.push_back({"wall", "wall", WallChain{{{-20, 4}, {20, 4}}, false}, 0, 2.5, {}});
  world.robot.X_WR = {{0, 1}, kPi / 2};
  return world;
}

// Four walls, a column, a walker with a towed cylinder.
World busy_hall() {
  World world;
  world.solids.push_back({"hall", "wall", WallChain{{{-4, -1}, {4, -1}, {4, 6}, {-4, 6}}, true}, 0, 2.5, {}});
  world.solids.push_back({"column", "column", Cylinder{{1.5, 3}, 0.25}, 0, 2.5, {}});
  world.solids.push_back({"box", "box", Box{{{-2.5, 2}, 0.2}, {0.6, 0.4}}, 0, 1, {}});
  Walker walker;
  walker.id = "anna";
  walker.path = {{{-1, 2}, {3, 2}, {3, 5}, {-3, 5}}, true, 0.5, false};
  walker.tow = Tow{};
  walker.tow->id = "cyl";
  world.walkers.push_back(walker);
  world.robot.X_WR = {{0, 0}, kPi / 2};
  world.robot.drive = {Wait{1}, Go{0.3}, Turn{0.5}};
  return world;
}

SimulationOptions ideal() {
  SimulationOptions options;
  options.lms.noise_sigma_m = 0.0;
  options.lms.effects.sweep = 0.0;  // each rotation at one instant
  return options;
}

std::vector<LaserScan> all_scans(SimulatedLms& lms) {
  std::vector<LaserScan> scans;
  LaserScan scan;
  while (lms.next(scan, kNoWait)) scans.push_back(scan);
  return scans;
}

std::vector<std::uint64_t> bits_of(const World& world, const SimulationOptions& options) {
  SimulatedLms lms(world, options);
  std::vector<std::uint64_t> bits;
  for (const LaserScan& scan : all_scans(lms)) {
    for (const double range_m : scan.range_m) bits.push_back(std::bit_cast<std::uint64_t>(range_m));
  }
  return bits;
}

const ObjectTruth& object_named(const Truth& truth, const std::string& id) {
  const auto found = std::find_if(truth.objects.begin(), truth.objects.end(),
                                  [&](const ObjectTruth& o) { return o.id == id; });
  if (found == truth.objects.end()) throw std::runtime_error("no object " + id);
  return *found;
}

TEST(SimulatedLmsTest, AWallAheadIsSeenAtItsDistanceToTheMillimetre) {
  SimulatedLms lms(wall_ahead(), ideal());
  LaserScan scan;
  ASSERT_TRUE(lms.next(scan, kNoWait));
  ASSERT_EQ(scan.num_beams(), 361);
  for (int i = 0; i < 361; ++i) {
    const double range_m = 3.0 / std::max(1e-9, std::cos(scan.geometry.bearing_rad(i)));
    if (range_m < 8.18) {
      EXPECT_NEAR(scan.range_m[i], range_m, 0.0005 + 1e-9) << i;
      EXPECT_NEAR(std::remainder(scan.range_m[i], 0.001), 0.0, 1e-9) << i;
    }
    if (range_m > 8.184) {
      EXPECT_EQ(scan.range_m[i], kNoEcho) << i;
    }
  }
}

TEST(SimulatedLmsTest, InCentimetresItSeesTenTimesAsFarInCoarserSteps) {
  SimulationOptions options = ideal();
  options.lms.unit = RangeUnit::kCentimetre;
  SimulatedLms lms(wall_ahead(), options);
  EXPECT_EQ(lms.geometry().max_range_m, 81.82);
  LaserScan scan;
  ASSERT_TRUE(lms.next(scan, kNoWait));
  const int beam = 180 + 2 * 70;
  EXPECT_NEAR(scan.range_m[beam], 3.0 / std::cos(radians(70)), 0.005 + 1e-9);
  EXPECT_NEAR(std::remainder(scan.range_m[beam], 0.01), 0.0, 1e-9);
}

TEST(SimulatedLmsTest, NoiseHasTheSigmaThatWasAskedFor) {
  SimulationOptions options = ideal();
  options.lms.noise_sigma_m = 0.012;
  options.duration_s = 100.0;
  SimulatedLms lms(wall_ahead(), options);
  double sum = 0.0;
  double sum_sq = 0.0;
  double count = 0.0;
  for (const LaserScan& scan : all_scans(lms)) {
    for (int i = 120; i <= 240; ++i) {
      const double error_m = scan.range_m[i] - 3.0 / std::cos(scan.geometry.bearing_rad(i));
      sum += error_m;
      sum_sq += error_m * error_m;
      ++count;
    }
  }
  // Millimetre steps add the variance of a uniform distribution. Limits: 4.5 standard errors.
  const double variance = 0.012 * 0.012 + 1e-6 / 12;
  EXPECT_NEAR(sum / count, 0.0, 4.5 * std::sqrt(variance / count));
  EXPECT_NEAR(sum_sq / count, variance, 4.5 * variance * std::sqrt(2.0 / count));
}

TEST(SimulatedLmsTest, ScansComeAtTheirPeriodUntilTheDurationIsOver) {
  SimulationOptions options = ideal();
  options.duration_s = 0.6;  // 0.6 / 0.2 is 2.9999... in binary
  SimulatedLms lms(wall_ahead(), options);
  EXPECT_EQ(lms.truth(), nullptr);
  const std::vector<LaserScan> scans = all_scans(lms);
  ASSERT_EQ(scans.size(), 3U);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(scans[k].index, k);
    EXPECT_NEAR(scans[k].time_s, 0.2 * k, 1e-12);
  }
  LaserScan untouched;
  untouched.index = 42;
  EXPECT_FALSE(lms.next(untouched, kNoWait));
  EXPECT_EQ(untouched.index, 42);
}

TEST(SimulatedLmsTest, TheGeometryTellsTheInterlaceAndWhenEachBeamIsMeasured) {
  SimulationOptions options = ideal();
  const ScanGeometry half = SimulatedLms(wall_ahead(), options).geometry();
  EXPECT_EQ(half.num_beams, 361);
  EXPECT_DOUBLE_EQ(half.first_rad, -kPi / 2);
  EXPECT_EQ(half.timing.num_rotations, 2);
  EXPECT_DOUBLE_EQ(half.timing.offset_s(100), 0.0);
  EXPECT_DOUBLE_EQ(half.timing.offset_s(101), 1.0 / 75);
  options.lms.step_rad = radians(1.0);
  EXPECT_EQ(SimulatedLms(wall_ahead(), options).geometry().timing.num_rotations, 1);
  options.lms.step_rad = radians(0.25);
  options.lms.fov_rad = radians(100.0);
  const ScanGeometry quarter = SimulatedLms(wall_ahead(), options).geometry();
  EXPECT_EQ(quarter.num_beams, 401);
  EXPECT_EQ(quarter.timing.num_rotations, 4);
}

// A wall straight ahead of a robot that goes towards it at 0.5 m/s is 0.5 / 75 m nearer for odd beams.
TEST(SimulatedLmsTest, InterlacedBeamsShearByTheRobotsWayInOneRotation) {
  World world = wall_ahead();
  world.robot.speed_m_per_s = 0.5;
  world.robot.drive = {Go{2.0}};
  SimulationOptions options = ideal();
  options.duration_s = 1.1;
  SimulatedLms lms(world, options);
  const LaserScan scan = all_scans(lms).back();
  const double distance_m = 3.0 - 0.5 * 1.0;
  EXPECT_NEAR(scan.range_m[180], distance_m, 0.0005 + 1e-9);
  EXPECT_NEAR(scan.range_m[181], (distance_m - 0.5 / 75) / std::cos(radians(0.5)), 0.0005 + 1e-9);
  EXPECT_NEAR(lms.truth()->beams[181].range_m, (distance_m - 0.5 / 75) / std::cos(radians(0.5)), 1e-9);
}

// A leg that swings across the view at 2.8 m/s moves by 37 mm in one rotation.
TEST(SimulatedLmsTest, InterlacedBeamsShearALegByItsWayInOneRotation) {
  World world;
  Walker walker;
  walker.id = "anna";
  walker.path.points_m = {{-10, 2}, {10, 2}};
  world.walkers.push_back(walker);
  world.robot.X_WR = {{0, 0}, kPi / 2};
  SimulationOptions options = ideal();
  options.duration_s = 14.0;
  SimulatedLms lms(world, options);
  const Gait gait(walker, 0, world.robot.laser_height_m);
  const double ratio = 0.28 / walker.leg_length_m;
  const double swing_m_per_s = (1.0 - ratio) * 1.44 / (0.4 * cycle_s(1.37)) + ratio * 1.37;
  LaserScan scan;
  int num_on_leg = 0;
  double largest_shear_m = 0.0;
  while (lms.next(scan, kNoWait)) {
    const WalkerState even = gait.state_at(scan.time_s);
    const WalkerState odd = gait.state_at(scan.time_s + 1.0 / 75);
    for (int i = 0; i < scan.num_beams(); ++i) {
      const BeamTruth& beam = lms.truth()->beams[i];
      if (beam.object == kNoObject) continue;
      ++num_on_leg;
      const WalkerState& then = i % 2 == 0 ? even : odd;
      const bool left = lms.truth()->objects[beam.object].id == "anna.left_leg";
      const double bearing_rad = scan.geometry.bearing_rad(i);
      const Vector2d p_WQ =
          lms.truth()->X_WS * (beam.range_m * Vector2d(std::cos(bearing_rad), std::sin(bearing_rad)));
      ASSERT_NEAR((p_WQ - (left ? then.left_leg_m : then.right_leg_m)).norm(), walker.leg_radius_m, 1e-9);
      const Vector2d shear_m = left ? odd.left_leg_m - even.left_leg_m : odd.right_leg_m - even.right_leg_m;
      largest_shear_m = std::max(largest_shear_m, shear_m.norm());
    }
  }
  EXPECT_GT(num_on_leg, 100);
  EXPECT_NEAR(largest_shear_m, swing_m_per_s / 75, 1e-9);
  EXPECT_NEAR(largest_shear_m, 0.037, 0.0005);  // published to the millimetre
}

// At 1 m/s towards the wall, what is cast at most 1.25 ms before or after a beam's time is 1.25 mm off.
TEST(SimulatedLmsTest, HoweverSlowTheMirrorEachBeamIsMeasuredAtItsTime) {
  World world = wall_ahead();
  world.robot.speed_m_per_s = 1.0;
  world.robot.drive = {Go{2.0}};
  for (const char* name : {"sick_lms200", "hokuyo_urg04lx", "hokuyo_utm30lx", "rplidar_a1", "sick_tim5xx"}) {
    SimulationOptions options{.lms = sensor_preset(name)};
    options.duration_s = 1.0;
    SimulatedLms lms(world, options);
    const LaserScan scan = all_scans(lms).back();
    int num_on_wall = 0;
    for (int i = 0; i < scan.num_beams(); ++i) {
      const double bearing_rad = scan.geometry.bearing_rad(i);
      if (std::abs(bearing_rad) > radians(40.0)) continue;
      ++num_on_wall;
      const double distance_m = 3.0 - scan.time_s - scan.geometry.timing.offset_s(i);
      ASSERT_NEAR(lms.truth()->beams[i].range_m * std::cos(bearing_rad), distance_m, 0.00125 + 1e-9)
          << name << ", beam " << i;
    }
    EXPECT_GT(num_on_wall, 75) << name;
  }
}

TEST(SimulatedLmsTest, WithoutInterlaceAllBeamsAreMeasuredAtOnce) {
  World world = wall_ahead();
  world.robot.drive = {Go{2.0}};
  SimulationOptions options = ideal();
  options.duration_s = 1.1;
  options.lms.interlace = false;
  SimulatedLms lms(world, options);
  all_scans(lms);
  const double distance_m = 3.0 - 0.3 * 1.0;
  EXPECT_NEAR(lms.truth()->beams[181].range_m, distance_m / std::cos(radians(0.5)), 1e-9);
}

TEST(SimulatedLmsTest, TruthNamesEveryObjectOnce) {
  SimulatedLms lms(busy_hall(), ideal());
  LaserScan scan;
  ASSERT_TRUE(lms.next(scan, kNoWait));
  std::string names;
  for (const ObjectTruth& object : lms.truth()->objects) names += object.id + ":" + object.label + " ";
  EXPECT_EQ(
      names,
      "hall.0:wall hall.1:wall hall.2:wall hall.3:wall column:column box.0:box box.1:box box.2:box box.3:box "
      "anna.left_leg:leg anna.right_leg:leg cyl:mobile_cylinder ");
}

TEST(SimulatedLmsTest, TruthPlacesStillThingsInTheSensorFrame) {
  World world = busy_hall();
  world.robot.X_RS = {{0.1, 0}, 0.0};
  SimulatedLms lms(world, ideal());
  LaserScan scan;
  ASSERT_TRUE(lms.next(scan, kNoWait));
  const Truth& truth = *lms.truth();
  EXPECT_NEAR((truth.X_WS.p_m - Vector2d(0, 0.1)).norm(), 0.0, 1e-12);
  const ObjectTruth& column = object_named(truth, "column");
  EXPECT_NEAR((column.center_m - Vector2d(2.9, -1.5)).norm(), 0.0, 1e-9);  // 2.9 m ahead, 1.5 m to the right
  EXPECT_EQ(column.radius_m, 0.25);
  EXPECT_EQ(column.primitive, Primitive::kCircle);
  const ObjectTruth& wall = object_named(truth, "hall.2");
  EXPECT_EQ(wall.primitive, Primitive::kLine);
  EXPECT_NEAR((wall.from_m - Vector2d(5.9, -4)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((wall.to_m - Vector2d(5.9, 4)).norm(), 0.0, 1e-9);
  EXPECT_EQ(object_named(truth, "anna.left_leg").primitive, Primitive::kLeg);
}

TEST(SimulatedLmsTest, EveryBeamLiesOnTheObjectThatTruthSaysItMet) {
  SimulationOptions options = ideal();
  options.lms.interlace = false;  // so that one pose holds for all beams
  SimulatedLms lms(busy_hall(), options);
  LaserScan scan;
  while (lms.next(scan, kNoWait)) {
    const Truth& truth = *lms.truth();
    std::vector<int> num_beams(truth.objects.size(), 0);
    for (int i = 0; i < scan.num_beams(); ++i) {
      const BeamTruth& beam = truth.beams[i];
      ASSERT_NE(beam.object, kNoObject) << i;
      ++num_beams[beam.object];
      EXPECT_NEAR(scan.range_m[i], beam.range_m, 0.0005 + 1e-9);
      const ObjectTruth& object = truth.objects[beam.object];
      const double bearing_rad = scan.geometry.bearing_rad(i);
      const Vector2d u(std::cos(bearing_rad), std::sin(bearing_rad));
      const Vector2d p_SQ = beam.range_m * u;
      Vector2d normal = (object.center_m - p_SQ).normalized();
      if (object.primitive == Primitive::kLine) {
        const Vector2d along = (object.to_m - object.from_m).normalized();
        normal = {-along.y(), along.x()};
        EXPECT_NEAR(normal.dot(p_SQ - object.from_m), 0.0, 1e-9);
      } else {
        EXPECT_NEAR((p_SQ - object.center_m).norm(), object.radius_m, 1e-9);
      }
      // Near grazing, acos and asin lose half of the digits.
      EXPECT_NEAR(beam.incidence_rad, std::acos(std::min(1.0, std::abs(normal.dot(u)))), 1e-6);
    }
    for (std::size_t k = 0; k < num_beams.size(); ++k) {
      EXPECT_EQ(truth.objects[k].num_clean_beams, num_beams[k]) << truth.objects[k].id;
    }
  }
}

TEST(SimulatedLmsTest, TruthSaysWhatIsThereToBeFound) {
  SimulatedLms lms(busy_hall(), ideal());
  LaserScan scan;
  ASSERT_TRUE(lms.next(scan, kNoWait));
  EXPECT_EQ(object_named(*lms.truth(), "column").visibility, Visibility::kResolvable);
  EXPECT_EQ(object_named(*lms.truth(), "hall.2").visibility, Visibility::kResolvable);
  EXPECT_EQ(object_named(*lms.truth(), "hall.0").visibility, Visibility::kHidden);  // behind the laser
}

TEST(SimulatedLmsTest, WhatIsTooFarReturnsNothingAndIsHidden) {
  World world = wall_ahead();
  std::get<WallChain>(world.solids[0].shape).corners_m = {{-20, 10}, {20, 10}};
  SimulatedLms lms(world, ideal());
  LaserScan scan;
  ASSERT_TRUE(lms.next(scan, kNoWait));
  for (int i = 0; i < scan.num_beams(); ++i) {
    EXPECT_EQ(scan.range_m[i], kNoEcho);
    EXPECT_EQ(lms.truth()->beams[i].object, kNoObject);
    EXPECT_EQ(lms.truth()->beams[i].range_m, kNoEcho);
  }
  EXPECT_EQ(lms.truth()->objects[0].num_clean_beams, 0);
  EXPECT_EQ(lms.truth()->objects[0].visibility, Visibility::kHidden);
}

TEST(SimulatedLmsTest, AnEmptyWorldReturnsNothing) {
  SimulatedLms lms(World{}, SimulationOptions{});
  LaserScan scan;
  ASSERT_TRUE(lms.next(scan, kNoWait));
  EXPECT_TRUE(std::all_of(scan.range_m.begin(), scan.range_m.end(), [](double r) { return r == kNoEcho; }));
  EXPECT_TRUE(lms.truth()->objects.empty());
}

TEST(SimulatedLmsTest, SeatsAboveTheLaserAreNotSeen) {
  World world = wall_ahead();
  world.solids.push_back({"seat", "bench", Box{{{0, 2}, 0}, {2, 0.4}}, 0.4, 0.45, {}});
  SimulatedLms lms(world, ideal());
  LaserScan scan;
  ASSERT_TRUE(lms.next(scan, kNoWait));
  EXPECT_EQ(scan.range_m[180], 3.0);
  EXPECT_EQ(lms.truth()->objects.size(), 1U);
}

TEST(SimulatedLmsTest, TheStateIsThatOfTheScansTime) {
  SimulatedLms lms(busy_hall(), SimulationOptions{});
  EXPECT_EQ(lms.state().time_s, 0.0);
  EXPECT_EQ(lms.state().walkers.size(), 1U);
  const Vector2d start_m = lms.state().walkers[0].X_WP.p_m;
  LaserScan scan;
  for (int k = 0; k < 3; ++k) ASSERT_TRUE(lms.next(scan, kNoWait));
  EXPECT_NEAR(lms.state().time_s, 0.4, 1e-12);
  EXPECT_NEAR((lms.state().walkers[0].X_WP.p_m - start_m).norm(), 0.4 * 1.37, 1e-9);  // straight so far
}

TEST(SimulatedLmsTest, SameSeedSameBitsOtherSeedOtherBits) {
  SimulationOptions options;
  options.seed = 11;
  const std::vector<std::uint64_t> first = bits_of(busy_hall(), options);
  EXPECT_EQ(first.size(), 50U * 361U);
  EXPECT_EQ(first, bits_of(busy_hall(), options));
  options.seed = 12;
  EXPECT_NE(first, bits_of(busy_hall(), options));
}

TEST(SimulatedLmsTest, NoiseOfAScanDoesNotDependOnTheScansBefore) {
  SimulationOptions options;
  const std::vector<std::uint64_t> whole = bits_of(wall_ahead(), options);
  options.lms.scan_period_s = 1.0;  // fewer scans, but the k-th scan of a still world stays the k-th scan
  const std::vector<std::uint64_t> fewer = bits_of(wall_ahead(), options);
  EXPECT_TRUE(std::equal(fewer.begin(), fewer.end(), whole.begin()));
}

// However seldom there are scans.
TEST(SimulatedLmsTest, SeesWhoWalksThroughAWallBetweenScans) {
  for (const double period_s : {0.2, 1.0, 5.0}) {
    World world = wall_ahead();
    Walker walker;
    walker.id = "ann";
    walker.path = {{{1, 2.5}, {1, 8}}, false, 0.0, false};
    world.walkers.push_back(walker);
    SimulationOptions options = ideal();
    options.lms.scan_period_s = period_s;
    options.duration_s = 5.5;
    SimulatedLms lms(world, options);
    all_scans(lms);
    ASSERT_GE(lms.collisions().size(), 1u) << period_s;
    EXPECT_EQ(lms.collisions()[0].first, "ann");
    EXPECT_EQ(lms.collisions()[0].second, "wall");
  }
}

TEST(SimulatedLmsTest, RefusesBadWorldsAndOptions) {
  World world = wall_ahead();
  world.robot.radius_m = -1.0;
  EXPECT_THROW(SimulatedLms(world, SimulationOptions{}), InputError);
  SimulationOptions options;
  for (const double duration_s : {0.0, -1.0, std::nan(""), 1e9}) {
    options.duration_s = duration_s;
    EXPECT_THROW(SimulatedLms(wall_ahead(), options), InputError);
  }
  options = {};
  options.lms.noise_sigma_m = -0.1;
  EXPECT_THROW(SimulatedLms(wall_ahead(), options), InputError);
}

}  // namespace
}  // namespace scanbed::sim
