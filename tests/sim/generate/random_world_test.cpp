// SPDX-License-Identifier: MIT
#include "sim/generate/random_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include "sim/world/crowd.hpp"
#include "sim/world/drive_plan.hpp"
#include "sim/world/gait.hpp"
#include "sim/world/solid_geometry.hpp"

namespace scanbed::sim {
namespace {

constexpr WorldKind kKinds[] = {WorldKind::kRooms, WorldKind::kCorridors};
constexpr int kNumSeeds = 500;
constexpr double kHeight_m = 0.28;

// The world as it is drawn before anybody rehearses: what stands does not change by that.
World drawn(WorldKind kind, int seed) {
  return random_world(kind, seed, kHeight_m, 0.0);
}

// All that tells one world from another, in one text.
std::string fingerprint(const World& world) {
  std::string text;
  for (const Solid& solid : world.solids) {
    text += solid.id;
    for (const Edge& edge : outline(solid.shape)) text += "," + std::to_string(edge.a_m.x());
    if (const auto* cylinder = std::get_if<Cylinder>(&solid.shape)) {
      text += "," + std::to_string(cylinder->center_m.y()) + "," + std::to_string(cylinder->radius_m);
    }
  }
  for (const Walker& walker : world.walkers) {
    text += walker.id + "," + std::to_string(walker.path.points_m[0].x()) + "," +
            std::to_string(walker.leg_radius_m);
  }
  return text + std::to_string(world.robot.X_WR.theta_rad);
}

double between_legs_m(const WalkerState& a, const WalkerState& b) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& p_m : {a.left_leg_m, a.right_leg_m}) {
    for (const Eigen::Vector2d& q_m : {b.left_leg_m, b.right_leg_m}) {
      least_m = std::min(least_m, (p_m - q_m).norm());
    }
  }
  return least_m;
}

// Of the nearer leg's middle to solids and to the robot's body.
double clearance_m(const World& world, const Pose2& X_WR, const WalkerState& person) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& p_m : {person.left_leg_m, person.right_leg_m}) {
    least_m = std::min(least_m, (p_m - X_WR.p_m).norm() - world.robot.radius_m);
    for (const Solid& solid : world.solids) {
      if (is_at_height(solid, kHeight_m)) least_m = std::min(least_m, sim::clearance_m(solid.shape, p_m));
    }
  }
  return least_m;
}

TEST(RandomWorldTest, ValidatesForEverySeed) {
  for (const WorldKind kind : kKinds) {
    for (int seed = 0; seed < kNumSeeds; ++seed) {
      EXPECT_NO_THROW(drawn(kind, seed).validate()) << seed;
    }
  }
}

TEST(RandomWorldTest, IsTheSameForTheSameSeedAndAnotherForAnother) {
  std::set<std::string> seen;
  for (const WorldKind kind : kKinds) {
    for (int seed = 0; seed < kNumSeeds; ++seed) {
      const std::string world = fingerprint(drawn(kind, seed));
      EXPECT_EQ(world, fingerprint(drawn(kind, seed)));
      EXPECT_TRUE(seen.insert(world).second) << seed;
    }
  }
}

TEST(RandomWorldTest, NothingStandsInTheRobotsWay) {
  for (int seed = 0; seed < kNumSeeds; ++seed) {
    const World world = drawn(WorldKind::kCorridors, seed);
    const DrivePlan plan(world.robot);
    for (double time_s = 0.0; time_s < plan.end_s(); time_s += 0.5) {
      for (const Solid& solid : world.solids) {
        EXPECT_GE(clearance_m(solid.shape, plan.pose_at(time_s).p_m), world.robot.radius_m) << seed;
      }
    }
  }
}

TEST(RandomWorldTest, NobodyWalksThroughAThing) {
  for (const WorldKind kind : kKinds) {
    for (int seed = 0; seed < kNumSeeds; ++seed) {
      const World world = drawn(kind, seed);
      for (const Walker& walker : world.walkers) {
        const Gait gait(walker, 0, kHeight_m);
        for (double time_s = 0.0; time_s < 8.0; time_s += 0.25) {
          for (const Solid& solid : world.solids) {
            EXPECT_GT(clearance_m(solid.shape, gait.pose_at(time_s).p_m), 0.2) << seed << solid.id;
          }
        }
      }
    }
  }
}

// Between two looks of the rehearsal legs may graze: hence some overlap, and that rarely.
TEST(RandomWorldTest, NobodyWalksIntoAnybodyOrAnythingForHalfAMinute) {
  constexpr double kMostOverlap_m = 0.05;
  constexpr double kStep_s = 0.03;
  std::vector<WalkerState> people;
  int num_passes = 0;
  int num_grazes = 0;
  for (const WorldKind kind : kKinds) {
    for (int seed = 0; seed < 100; ++seed) {
      const World world = random_world(kind, seed, kHeight_m);
      ASSERT_NO_THROW(world.validate());
      const Crowd crowd(world, kHeight_m);
      const DrivePlan drive(world.robot);
      for (int k = 0; k * kStep_s < 30.0; ++k) {
        crowd.states_at(k * kStep_s, people);
        for (std::size_t i = 0; i < people.size(); ++i) {
          const double radius_m = world.walkers[i].leg_radius_m;
          EXPECT_GT(clearance_m(world, drive.pose_at(k * kStep_s), people[i]), radius_m - kMostOverlap_m)
              << seed;
          for (std::size_t other = 0; other < i; ++other) {
            const double gap_m =
                between_legs_m(people[i], people[other]) - radius_m - world.walkers[other].leg_radius_m;
            EXPECT_GT(gap_m, -kMostOverlap_m) << seed;
            num_grazes += gap_m < 0.0;
            num_passes += (people[i].X_WP.p_m - people[other].X_WP.p_m).norm() < 0.7;
          }
        }
      }
    }
  }
  EXPECT_GT(num_passes, 100);  // shoulder to shoulder they do walk
  EXPECT_LT(num_grazes, 0.01 * num_passes);
}

TEST(RandomWorldTest, TheRehearsalCostsFewPeople) {
  for (const WorldKind kind : kKinds) {
    int num_drawn = 0;
    int num_left = 0;
    for (int seed = 0; seed < 100; ++seed) {
      num_drawn += static_cast<int>(drawn(kind, seed).walkers.size());
      num_left += static_cast<int>(random_world(kind, seed, kHeight_m).walkers.size());
    }
    EXPECT_GT(num_left, 0.85 * num_drawn);
  }
}

TEST(RandomWorldTest, HoldsWhatItPromisesInMostSeeds) {
  for (const WorldKind kind : kKinds) {
    std::set<std::string> labels;
    int num_walkers = 0;
    for (int seed = 0; seed < 100; ++seed) {
      const World world = drawn(kind, seed);
      for (const Solid& solid : world.solids) labels.insert(solid.label);
      num_walkers += static_cast<int>(world.walkers.size());
    }
    for (const char* label : {"wall", "column", "post", "chair", "trash_can"}) {
      EXPECT_TRUE(labels.contains(label)) << label;
    }
    EXPECT_GT(num_walkers, 25);
  }
}

}  // namespace
}  // namespace scanbed::sim
