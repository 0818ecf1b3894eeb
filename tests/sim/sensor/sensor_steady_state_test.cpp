// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "sim/sensor/sensor_presets.hpp"
#include "sim/sensor/simulated_lms.hpp"
#include "tests/support/allocation_counter.hpp"

namespace scanbed::sim {
namespace {

World hall() {
  World world;
  world.solids = {
      {.id = "hall", .label = "wall", .shape = WallChain{{{-4, -1}, {4, -1}, {4, 6}, {-4, 6}}, true}},
      {.id = "column", .label = "column", .shape = Cylinder{{1.5, 3}, 0.25}},
      {.id = "box", .label = "box", .shape = Box{{{-2.5, 2}, 0.2}, {0.6, 0.4}}}};
  world.walkers = {
      {.id = "anna", .path = {{{-1, 2}, {3, 2}, {3, 5}, {-3, 5}}, true, 0.5, false}, .avoids = true},
      {.id = "berta", .path = {{{2.2, 4}, {-1.4, 4}}, true, 0.0, false}, .avoids = true}};
  world.robot.X_WR = {{0, 0}, kPi / 2};
  world.robot.drive = {Turn{1000.0}};
  return world;
}

// The largest scan comes early or late, so a first round lets every buffer grow.
TEST(SensorSteadyStateTest, PlanarScansAllocateNothing) {
  for (const std::string& name : sensor_preset_names()) {
    SimulationOptions options{.lms = sensor_preset(name), .duration_s = 1e5};
    SimulatedLms lms(hall(), options);
    LaserScan scan;
    for (int k = 0; k < 300; ++k) ASSERT_TRUE(lms.next(scan, RangeSensor::Seconds(0)));
    const std::int64_t before = testing::num_allocations();
    for (int k = 0; k < 100; ++k) lms.next(scan, RangeSensor::Seconds(0));
    EXPECT_EQ(testing::num_allocations() - before, 0) << name;
    ASSERT_TRUE(lms.collisions().empty()) << "to tell of them allocates";
  }
}

}  // namespace
}  // namespace scanbed::sim
