// SPDX-License-Identifier: MIT
#include "sim/generate/random_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sim/world/drive_plan.hpp"
#include "sim/world/gait.hpp"
#include "sim/world/solid_geometry.hpp"

namespace scanbed::sim {
namespace {

constexpr WorldKind kKinds[] = {WorldKind::kRooms, WorldKind::kCorridors};
constexpr int kNumSeeds = 500;
constexpr double kHeight_m = 0.28;

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

TEST(RandomWorldTest, ValidatesForEverySeed) {
  for (const WorldKind kind : kKinds) {
    for (int seed = 0; seed < kNumSeeds; ++seed) {
      EXPECT_NO_THROW(random_world(kind, seed, kHeight_m).validate()) << seed;
    }
  }
}

TEST(RandomWorldTest, IsTheSameForTheSameSeedAndAnotherForAnother) {
  std::set<std::string> seen;
  for (const WorldKind kind : kKinds) {
    for (int seed = 0; seed < kNumSeeds; ++seed) {
      const std::string world = fingerprint(random_world(kind, seed, kHeight_m));
      EXPECT_EQ(world, fingerprint(random_world(kind, seed, kHeight_m)));
      EXPECT_TRUE(seen.insert(world).second) << seed;
    }
  }
}

TEST(RandomWorldTest, NothingStandsInTheRobotsWay) {
  for (int seed = 0; seed < kNumSeeds; ++seed) {
    const World world = random_world(WorldKind::kCorridors, seed, kHeight_m);
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
      const World world = random_world(kind, seed, kHeight_m);
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

TEST(RandomWorldTest, HoldsWhatItPromisesInMostSeeds) {
  for (const WorldKind kind : kKinds) {
    std::set<std::string> labels;
    int num_walkers = 0;
    for (int seed = 0; seed < 100; ++seed) {
      const World world = random_world(kind, seed, kHeight_m);
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
