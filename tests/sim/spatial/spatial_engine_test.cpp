// SPDX-License-Identifier: MIT
#include "sim/spatial/spatial_engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/errors/input_error.hpp"
#include "sim/planar/planar_engine.hpp"
#include "sim/planar/ray_caster.hpp"
#include "sim/sensor/simulated_lms.hpp"
#include "tests/support/hall.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

World still_hall() {
  World world = test_hall();
  world.walkers.clear();
  world.solids.push_back({.id = "box", .label = "box", .shape = Box{{{-1.0, 2.0}, 0.4}, {0.5, 0.8}}});
  world.solids.push_back({.id = "wedge", .label = "box", .shape = Polygon{{{1, 2}, {2, 1.8}, {1.5, 2.6}}}});
  world.solids.push_back({.id = "screen", .label = "wall", .shape = WallChain{{{4, 1}, {5, 3}, {4.5, 4}}}});
  return world;
}

World towing_hall() {
  World world = test_hall();
  world.walkers.pop_back();
  world.walkers[0].path = {{{-3.2, 2.8}, {3.2, 2.8}, {3.2, 5.2}, {-3.2, 5.2}}, true, 0.6, false};
  world.walkers[0].speed_m_per_s = 1.0;
  return world;
}

std::vector<double> scan_of(Engine& engine) {
  RayCaster caster{ScanGeometry{}};
  caster.cast(engine.slice(), engine.sensor_in_plane());
  return caster.ranges_m();
}

const std::string& id_at(const Engine& engine, const RayCaster& caster, int i) {
  return engine.objects().at(caster.object(i)).id;
}

// What stands still is the same geometry in both, so the scans differ by rounding: far less than the
// millimetre that is asked for.
TEST(SpatialEngineTest, AStillWorldGivesTheScanOfThePlanarEngine) {
  World world = still_hall();
  world.robot.X_RS = {{0.1, 0.03}, 0.2};
  for (const double theta_rad : {kPi / 2, 0.3, -2.8}) {
    world.robot.X_WR.theta_rad = theta_rad;
    PlanarEngine planar(world);
    SpatialEngine spatial(world);
    RayCaster in_plane{ScanGeometry{}};
    RayCaster in_space{ScanGeometry{}};
    in_plane.cast(planar.slice(), planar.sensor_in_plane());
    in_space.cast(spatial.slice(), spatial.sensor_in_plane());
    for (int i = 0; i < in_plane.num_beams(); ++i) {
      ASSERT_NEAR(in_space.range_m(i), in_plane.range_m(i), 1e-9) << i;
      ASSERT_EQ(id_at(spatial, in_space, i), id_at(planar, in_plane, i)) << i;
      ASSERT_NEAR(in_space.incidence_rad(i), in_plane.incidence_rad(i), 1e-6) << i;
    }
  }
}

// The gait is the same, and the shanks pass through the same points in the laser's plane. But a shank that
// leans by a is cut in an ellipse, r by r / cos a, where the planar engine has a disc. A foot stands for 0.6
// of a stride of 1.44 m, so it is up to 0.43 m before or behind a hip 0.93 m high: cos a >= 0.90.
TEST(SpatialEngineTest, LegsAreCutWhereThePlanarEngineHasThem) {
  World world = test_hall();
  world.walkers.pop_back();
  world.walkers[0].tow.reset();
  PlanarEngine planar(world);
  SpatialEngine spatial(world);
  RayCaster caster{ScanGeometry{}};
  const Pose2 X_WS = world.robot.X_WR * world.robot.X_RS;
  const double radius_m = world.walkers[0].leg_radius_m;
  double widest_m = 0.0;
  int num_on_legs = 0;
  for (int k = 0; k <= 80; ++k) {
    planar.advance_to(0.05 * k);
    spatial.advance_to(0.05 * k);
    caster.cast(spatial.slice(), spatial.sensor_in_plane());
    const WalkerState& walker = planar.state().walkers[0];
    for (int i = 0; i < caster.num_beams(); ++i) {
      const std::string& id = id_at(spatial, caster, i);
      if (id != "student_A.left_leg" && id != "student_A.right_leg") continue;
      const double bearing_rad = ScanGeometry{}.bearing_rad(i);
      const Vector2d p_WQ =
          X_WS * (caster.range_m(i) * Vector2d(std::cos(bearing_rad), std::sin(bearing_rad)));
      const Vector2d leg_m = id == "student_A.left_leg" ? walker.left_leg_m : walker.right_leg_m;
      const double from_axis_m = (p_WQ - leg_m).norm();
      ASSERT_GE(from_axis_m, radius_m - 1e-9);
      widest_m = std::max(widest_m, from_axis_m);
      ++num_on_legs;
    }
  }
  EXPECT_GT(num_on_legs, 200);
  EXPECT_GT(widest_m, 1.03 * radius_m);  // shanks do lean
  EXPECT_LT(widest_m, radius_m / 0.90);
}

// How far apart both engines have the towed cylinder, in 30 s round the hall.
std::vector<double> distances_between_engines_m(const World& world) {
  PlanarEngine planar(world);
  SpatialEngine spatial(world);
  std::vector<double> distances_m;
  for (int k = 1; k <= 300; ++k) {
    planar.advance_to(0.1 * k);
    spatial.advance_to(0.1 * k);
    distances_m.push_back((planar.state().tows.at(0).center_m - spatial.state().tows.at(0).center_m).norm());
  }
  return distances_m;
}

// Both rub with mu m g on the floor and hang on a rope of the same length; but here the rope gives way by
// some millimetres, and the cylinder stands on some points of its rim, not on a disc.
TEST(SpatialEngineTest, ATowedCylinderTakesThePathOfThePlanarEngine) {
  const std::vector<double> off_m = distances_between_engines_m(towing_hall());
  EXPECT_LT(*std::max_element(off_m.begin(), off_m.end()), 0.05);
  EXPECT_LT(std::sqrt(std::inner_product(off_m.begin(), off_m.end(), off_m.begin(), 0.0) / 300), 0.02);
}

// A walker is at full speed at once, so the rope jerks; and friction pulls below where the rope does. (What
// glides on ice, or is pulled round corners at a run, swings at a slack rope: no two engines agree on that.)
TEST(SpatialEngineTest, SoItDoesHoweverItRubsAndWhateverItsSize) {
  World world = towing_hall();
  for (const auto& [radius_m, height_m] : {std::pair(0.25, 1.0), {0.15, 0.6}, {0.1, 0.4}}) {
    for (const double friction : {0.2, 0.6, 1.0}) {
      for (const double speed_m_per_s : {1.0, 1.4}) {
        Tow& tow = *world.walkers[0].tow;
        tow.radius_m = radius_m;
        tow.height_m = height_m;
        tow.friction = friction;
        world.walkers[0].speed_m_per_s = speed_m_per_s;
        const std::vector<double> off_m = distances_between_engines_m(world);
        EXPECT_LT(*std::max_element(off_m.begin(), off_m.end()), 0.10)
            << radius_m << " m, mu " << friction << ", " << speed_m_per_s << " m/s";
      }
    }
  }
}

TEST(SpatialEngineTest, WhereThingsAreDependsOnTheTimeAlone) {
  SpatialEngine often(towing_hall());
  for (int k = 1; k <= 333; ++k) often.advance_to(0.009 * k);
  SpatialEngine once(towing_hall());
  once.advance_to(0.009 * 333);
  EXPECT_EQ(often.state().tows[0].center_m, once.state().tows[0].center_m);
  EXPECT_EQ(scan_of(often), scan_of(once));
}

TEST(SpatialEngineTest, BetweenItsStepsACylinderMovesStraight) {
  SpatialEngine engine(towing_hall());
  std::vector<Vector2d> places;
  for (const double steps : {600.0, 600.25, 600.5, 601.0}) {
    engine.advance_to(steps / 300.0);
    places.push_back(engine.state().tows[0].center_m);
  }
  EXPECT_NEAR((places[1] - (0.75 * places[0] + 0.25 * places[3])).norm(), 0.0, 1e-6);
  EXPECT_NEAR((places[2] - (0.5 * places[0] + 0.5 * places[3])).norm(), 0.0, 1e-6);
}

TEST(SpatialEngineTest, ALaserTiltedDownSeesTheFloorThroughTheWholeSensor) {
  World world = still_hall();
  world.solids.resize(1);  // the walls
  world.robot.laser_pitch_rad = 0.1;
  SimulationOptions options;
  options.backend = Backend::kSpatial;
  options.lms.noise_sigma_m = 0.0;
  SimulatedLms lms(world, options);
  LaserScan scan;
  ASSERT_TRUE(lms.next(scan, RangeSensor::Seconds(0)));
  EXPECT_NEAR(scan.range_m[180], 0.28 / std::sin(0.1), 0.0006);
  EXPECT_EQ(lms.truth()->objects.at(lms.truth()->beams[180].object).id, "floor");
}

TEST(SpatialEngineTest, TruthOfTheSimulatedLaserAgreesInBothEngines) {
  SimulationOptions options;
  options.duration_s = 1.0;
  SimulatedLms planar(still_hall(), options);
  options.backend = Backend::kSpatial;
  SimulatedLms spatial(still_hall(), options);
  LaserScan a;
  LaserScan b;
  while (planar.next(a, RangeSensor::Seconds(0))) {
    ASSERT_TRUE(spatial.next(b, RangeSensor::Seconds(0)));
    EXPECT_EQ(a.range_m, b.range_m);  // same seed, same noise; rounding is below a millimetre's step
    for (const ObjectTruth& object : planar.truth()->objects) {
      const auto& others = spatial.truth()->objects;
      const auto other =
          std::find_if(others.begin(), others.end(), [&](const ObjectTruth& o) { return o.id == object.id; });
      ASSERT_NE(other, others.end()) << object.id;
      EXPECT_EQ(other->num_clean_beams, object.num_clean_beams) << object.id;
      EXPECT_EQ(other->visibility, object.visibility) << object.id;
      EXPECT_NEAR((other->center_m - object.center_m).norm(), 0.0, 1e-9) << object.id;
    }
  }
}

TEST(SpatialEngineTest, NamesAreNotUsedTwice) {
  SpatialEngine engine(test_hall());
  std::set<std::string> ids;
  for (const SliceObject& object : engine.objects()) EXPECT_TRUE(ids.insert(object.id).second) << object.id;
}

TEST(SpatialEngineTest, RefusesWorldsThatCannotBe) {
  World world = test_hall();
  world.walkers[0].tow->rope_m = 0.0;
  EXPECT_THROW(SpatialEngine{world}, InputError);
}

TEST(SpatialEngineTest, TimeDoesNotRunBackwards) {
  SpatialEngine engine(still_hall());
  engine.advance_to(1.0);
  EXPECT_DEATH(engine.advance_to(0.5), "broken promise");
  EXPECT_DEATH(engine.advance_to(std::nan("")), "broken promise");
}

}  // namespace
}  // namespace scanbed::sim
