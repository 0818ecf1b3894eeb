// SPDX-License-Identifier: MIT
#include "hw/cola/cola_laser.hpp"

#include <gtest/gtest.h>

#include "core/errors/input_error.hpp"
#include "hw/cola/emulated_cola.hpp"
#include "tests/support/running_device.hpp"
#include "tests/support/wide_sensor.hpp"

namespace scanbed::hw {
namespace {

using tests::RunningDevice;
using tests::WideSensor;

constexpr RangeSensor::Seconds kPatience{20.0};

ColaOptions network(int port) {
  ColaOptions options;
  options.host = "127.0.0.1";
  options.port = port;
  options.recovery.pause_s = 0.05;
  return options;
}

void expect_true_scans(RangeSensor& laser, int count, int num_beams) {
  LaserScan scan;
  for (int i = 0; i < count; ++i) {
    ASSERT_TRUE(laser.next(scan, kPatience));
    ASSERT_EQ(scan.num_beams(), num_beams);
    const int first = WideSensor::beam_at(scan.geometry.bearing_rad(0));
    const int shift = (static_cast<int>(std::lround(scan.range_m[0] * 1000.0)) - 1000 - first + 8000) % 4000;
    for (int beam = 0; beam < num_beams; ++beam) {
      const int there = WideSensor::beam_at(scan.geometry.bearing_rad(beam));
      ASSERT_DOUBLE_EQ(scan.range_m[static_cast<std::size_t>(beam)], WideSensor::range_m(shift, there));
    }
  }
}

TEST(ColaLaserTest, StreamsFromAnLms) {
  WideSensor source;
  EmulatedCola sensor({.is_paced = false}, source);
  RunningDevice running(sensor);
  const auto laser = open_cola(network(running.port()));
  expect_true_scans(*laser, 20, 541);
}

TEST(ColaLaserTest, StreamsFromATim) {
  WideSensor source;
  EmulatedCola sensor({.is_lms = false, .step = 10000, .scan_period_s = 0.066, .is_paced = false}, source);
  RunningDevice running(sensor);
  const auto laser = open_cola(network(running.port()));
  expect_true_scans(*laser, 20, 271);
}

TEST(ColaLaserTest, ConnectsAgainWhereTheSensorWentAway) {
  WideSensor source;
  EmulatedCola sensor({.is_paced = false, .num_spin_up_polls = 0}, source);
  auto running = std::make_unique<RunningDevice>(sensor);
  const int port = running->port();
  const auto laser = open_cola(network(port));
  expect_true_scans(*laser, 5, 541);
  running.reset();
  sensor.hang_up();
  running = std::make_unique<RunningDevice>(sensor, port);
  LaserScan scan;
  // What was waiting comes first; more than that must follow.
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(laser->next(scan, kPatience));
}

TEST(ColaLaserTest, ARefusedPasswordIsTheEnd) {
  WideSensor source;
  EmulatedCola sensor({.refuses_password = true}, source);
  RunningDevice running(sensor);
  const auto laser = open_cola(network(running.port()));
  LaserScan scan;
  EXPECT_THROW(laser->next(scan, kPatience), DeviceRefusal);
}

// A TiM scans by itself: nothing of what the log-in is for must be set.
TEST(ColaLaserTest, StreamsFromATimThatRefusesTheLogIn) {
  WideSensor source;
  EmulatedCola sensor(
      {.is_lms = false, .step = 10000, .scan_period_s = 0.066, .is_paced = false, .refuses_password = true},
      source);
  RunningDevice running(sensor);
  const auto laser = open_cola(network(running.port()));
  expect_true_scans(*laser, 20, 271);
}

TEST(ColaLaserTest, RefusesBadOptions) {
  EXPECT_THROW(open_cola({}), InputError);
  EXPECT_THROW(open_cola(network(70000)), InputError);
}

}  // namespace
}  // namespace scanbed::hw
