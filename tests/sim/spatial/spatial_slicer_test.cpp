// SPDX-License-Identifier: MIT
#include "sim/spatial/spatial_slicer.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "sim/planar/ray_caster.hpp"
#include "sim/spatial/laser_mount.hpp"
#include "sim/spatial/mjcf.hpp"
#include "sim/spatial/mujoco_model.hpp"
#include "sim/spatial/pose_actors.hpp"
#include "tests/support/hall.hpp"
#include "tests/support/mj_reference_caster.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A world at one moment, in MuJoCo and as slices.
class Scene {
 public:
  Scene(const World& world, const WorldState& state)
      : world_(world), state_(state), model_(load_model(mjcf_of(world_))), data_(make_data(*model_)) {
    ActorPoser(world_, *model_).put(state_, *data_);
    mj_kinematics(model_.get(), data_.get());
  }
  PlanarSlice slice(const LaserPlane& plane) {
    PlanarSlice result;
    SpatialSlicer slicer(world_, *model_);
    slicer.slice(*data_, plane, state_, result);
    objects_ = slicer.objects();
    return result;
  }
  const std::vector<SliceObject>& objects() const { return objects_; }
  const mjModel& model() const { return *model_; }
  const mjData& data() const { return *data_; }

 private:
  World world_;
  WorldState state_;
  ModelPtr model_;
  DataPtr data_;
  std::vector<SliceObject> objects_;
};

ScanGeometry full_turn(int num_beams) {
  ScanGeometry geometry;
  geometry.num_beams = num_beams;
  geometry.first_rad = -kPi;
  geometry.step_rad = 2.0 * kPi / num_beams;
  return geometry;
}

struct Limits {
  double least_m;
  double most_m;
};

// Meshes are in single precision, and at silhouettes and grazing beams that decides: the reference is asked
// about beams that are off by as much (0.2 microradian) to either side, above and below.
Limits reference_limits(const Scene& scene, const LaserPlane& plane, double bearing_rad) {
  constexpr double kOff_rad = 2e-7;
  const test::MjReferenceCaster reference(scene.model(), scene.data());
  Limits limits{kNoEcho, 0.0};
  for (const auto& [turn_rad, rise_rad] :
       {std::pair(0.0, 0.0), {kOff_rad, 0.0}, {-kOff_rad, 0.0}, {0.0, kOff_rad}, {0.0, -kOff_rad}}) {
    const Vector3d u_S(std::cos(bearing_rad + turn_rad), std::sin(bearing_rad + turn_rad), rise_rad);
    const double range_m = reference.cast(plane.p_WS, plane.R_WS * u_S.normalized());
    limits.least_m = std::min(limits.least_m, range_m);
    limits.most_m = std::max(limits.most_m, range_m);
  }
  return limits;
}

// Every beam against mj_ray; returns how many met anything.
int count_checked(Scene& scene, const LaserPlane& plane, int num_beams) {
  const ScanGeometry geometry = full_turn(num_beams);
  RayCaster caster(geometry);
  caster.cast(scene.slice(plane), {});
  int num_met = 0;
  for (int i = 0; i < num_beams; ++i) {
    const Limits limits = reference_limits(scene, plane, geometry.bearing_rad(i));
    // Rounding in both, a nanometre or so each; and a sheet is 5 nm thick on either side.
    const double slack_m = 1e-6 * (1.0 + std::min(limits.most_m, 1000.0));
    // The floor ends nowhere, in MuJoCo; here after 10 km.
    const double range_m = caster.range_m(i) > 5000.0 ? kNoEcho : caster.range_m(i);
    const double most_m = limits.most_m > 5000.0 ? kNoEcho : limits.most_m;
    if (range_m < limits.least_m - slack_m || range_m > most_m + slack_m) {
      ADD_FAILURE() << "beam " << i << ": " << range_m << ", mj_ray " << limits.least_m << " to " << most_m;
      return -1;
    }
    if (range_m < kNoEcho) ++num_met;
  }
  return num_met;
}

class RandomNumbers {
 public:
  explicit RandomNumbers(unsigned seed) : engine_(seed) {}
  double in(double least, double most) {
    return least + (most - least) * static_cast<double>(engine_()) / 4294967295.0;
  }
  int count(int most) { return static_cast<int>(in(0.0, most + 0.999)); }
  Vector2d place(double reach_m) { return {in(-reach_m, reach_m), in(-reach_m, reach_m)}; }

 private:
  std::mt19937 engine_;
};

SolidShape random_shape(RandomNumbers& random) {
  const Vector2d p_WQ = random.place(6.0);
  switch (random.count(3)) {
    case 0:
      return WallChain{{p_WQ, p_WQ + random.place(3.0), p_WQ + Vector2d(4, 0.1)}, random.count(1) == 1};
    case 1:
      return Cylinder{p_WQ, random.in(0.02, 1.0)};
    case 2:
      return Box{{p_WQ, random.in(-3.0, 3.0)}, {random.in(0.05, 3.0), random.in(0.05, 3.0)}};
    default: {
      Polygon polygon;
      const double size_m = random.in(0.1, 1.5);
      const int num_corners = 3 + random.count(4);
      for (int i = 0; i < num_corners; ++i) {
        const double angle_rad = 2.0 * kPi * i / num_corners + random.in(0.0, 0.5);
        polygon.corners_m.push_back(p_WQ + size_m * Vector2d(std::cos(angle_rad), std::sin(angle_rad)));
      }
      return polygon;
    }
  }
}

World random_world(RandomNumbers& random) {
  World world;
  const int num_solids = random.count(8);
  for (int i = 0; i < num_solids; ++i) {
    Solid solid{.id = "s" + std::to_string(i), .label = "thing", .shape = random_shape(random)};
    solid.bottom_m = random.in(-0.2, 0.6);
    solid.top_m = solid.bottom_m + random.in(0.05, 2.0);
    world.solids.push_back(solid);
  }
  world.walkers = {{.id = "ann", .path = {{{0, 0}, {1, 0}}}, .tow = Tow{.id = "cyl", .radius_m = 0.3}}};
  world.walkers[0].leg_radius_m = random.in(0.03, 0.12);
  world.robot.laser_height_m = random.in(0.05, 1.9);
  world.robot.X_RS = {random.place(0.2), random.in(-3.0, 3.0)};
  // Upright lasers are a case of their own.
  if (random.count(3) > 0) {
    world.robot.laser_pitch_rad = random.in(-1.2, 1.2);
    world.robot.laser_roll_rad = random.in(-1.2, 1.2);
  }
  return world;
}

TEST(SpatialSlicerTest, EveryBeamIsWhatMjRaySaysInRandomWorldsWithTiltedLasers) {
  int num_met = 0;
  rc::check([&num_met] {
    RandomNumbers random(*rc::gen::arbitrary<unsigned>());
    const World world = random_world(random);
    WorldState state;
    state.X_WR = {random.place(4.0), random.in(-3.0, 3.0)};
    state.walkers = {test_stride(0, {random.place(3.0), random.in(-3.0, 3.0)})};
    state.tows = {{.walker = 0, .present = true, .center_m = random.place(3.0)}};
    Scene scene(world, state);
    const int num = count_checked(scene, laser_plane(world.robot, state.X_WR), 181);
    RC_ASSERT(num >= 0);
    num_met += num;
  });
  EXPECT_GT(num_met, 1000);  // the worlds are not empty
}

class HallSliceTest : public ::testing::Test {
 protected:
  int num_met(const std::string& id, const LaserPlane& plane) {
    Scene scene(world_, state_);
    RayCaster caster(full_turn(721));
    caster.cast(scene.slice(plane), {});
    int num = 0;
    for (int i = 0; i < caster.num_beams(); ++i) {
      if (caster.object(i) != kNoObject && scene.objects()[caster.object(i)].id == id) ++num;
    }
    return num;
  }
  LaserPlane plane() const { return laser_plane(world_.robot, state_.X_WR); }

  World world_ = test_hall();
  WorldState state_ = test_hall_state(world_);
};

TEST_F(HallSliceTest, TheHallIsWhatMjRaySaysUprightAndTilted) {
  Scene scene(world_, state_);
  EXPECT_EQ(count_checked(scene, plane(), 721), 721);
  world_.robot.laser_pitch_rad = 0.15;
  world_.robot.laser_roll_rad = -0.05;
  EXPECT_GT(count_checked(scene, plane(), 721), 600);
}

TEST_F(HallSliceTest, AnUprightLaserSeesBenchFeetButNoSeatAndNoFloor) {
  EXPECT_GT(num_met("bench_L.foot_0", plane()), 0);
  EXPECT_GT(num_met("student_A.left_leg", plane()), 0);
  EXPECT_GT(num_met("cyl", plane()), 0);
  for (int edge = 0; edge < 4; ++edge) {
    EXPECT_EQ(num_met("bench_L.seat." + std::to_string(edge), plane()), 0);
  }
  EXPECT_EQ(num_met("floor", plane()), 0);
}

TEST_F(HallSliceTest, ALaserTiltedDownSeesTheFloorAtItsHeightOverTheSine) {
  world_.robot.laser_pitch_rad = 0.2;
  Scene scene(world_, state_);
  RayCaster caster(full_turn(720));
  caster.cast(scene.slice(plane()), {});
  const int ahead = 360;
  ASSERT_EQ(scene.objects()[caster.object(ahead)].id, "floor");
  EXPECT_NEAR(caster.range_m(ahead), 0.28 / std::sin(0.2), 1e-9);
  EXPECT_NEAR(caster.incidence_rad(ahead), kPi / 2 - 0.2, 1e-6);
}

TEST_F(HallSliceTest, ALaserTiltedUpSeesTheSeats) {
  // From 0.28 m, 6.5 m away, up to between 0.40 and 0.48 m.
  world_.robot.laser_pitch_rad = -std::atan2(0.16, 6.3);
  int num = 0;
  for (int edge = 0; edge < 4; ++edge) num += num_met("bench_L.seat." + std::to_string(edge), plane());
  EXPECT_GT(num, 0);
}

TEST_F(HallSliceTest, WhoIsNotPresentIsNotSeen) {
  state_.walkers[0].present = false;
  state_.tows[0].present = false;
  EXPECT_EQ(num_met("student_A.left_leg", plane()), 0);
  EXPECT_EQ(num_met("cyl", plane()), 0);
  EXPECT_GT(num_met("student_B.left_leg", plane()), 0);
}

TEST_F(HallSliceTest, TheRobotDoesNotSeeItself) {
  world_.robot.X_RS = {};
  Scene scene(world_, state_);
  RayCaster caster(full_turn(721));
  caster.cast(scene.slice(plane()), {});
  EXPECT_GT(*std::min_element(caster.ranges_m().begin(), caster.ranges_m().end()), 0.4);
}

}  // namespace
}  // namespace scanbed::sim
