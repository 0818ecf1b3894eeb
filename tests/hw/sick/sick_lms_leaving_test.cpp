// SPDX-License-Identifier: MIT
// How the driver of the LMS leaves its sensor, whatever it is at when it is stopped or gives up.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <thread>

#include "core/errors/sensor_fault.hpp"
#include "hw/serial/serial_port.hpp"
#include "hw/serial/steady_clock.hpp"
#include "hw/sick/lms_session.hpp"
#include "hw/sick/sick_lms.hpp"
#include "tests/support/running_emulator.hpp"

namespace scanbed::hw {
namespace {

using tests::quick_driver;
using tests::quick_sensor;
using tests::quick_sensor_at;
using tests::RunningEmulator;
using Seconds = RangeSensor::Seconds;

// Longer than any machine stands still.
constexpr Seconds kLeavingPatience{60.0};

TEST(SickLmsTest, GivesTheBaudBackAlsoAfterARefusal) {
  EmulatorOptions sensor = quick_sensor();
  sensor.faults = {{LmsFaultKind::kRefuse, 0.0}, {LmsFaultKind::kRefuse, 0.0}};
  RunningEmulator emulator(sensor);
  SickOptions options = quick_driver(emulator.port());
  options.patience.close_s = kLeavingPatience.count();
  {
    SickLms laser(options);
    LaserScan scan;
    EXPECT_THROW(laser.next(scan, kLeavingPatience), SensorFault);
  }
  EXPECT_EQ(emulator.end().baud(), 9600);
}

void wait_for(const SickLms& laser, const std::string& state) {
  const double end_s = steady_now_s() + kLeavingPatience.count();
  while (laser.report().state != state) {
    ASSERT_LT(steady_now_s(), end_s) << state;
    std::this_thread::sleep_for(Seconds(0.001));
  }
}

/// Whether the sensor answers at a baud, at once or in a while.
bool is_found_at(int baud, const std::string& path) {
  const StopSignal stop;
  for (const double end_s = steady_now_s() + kLeavingPatience.count(); steady_now_s() < end_s;) {
    try {
      SerialPort port(path);
      LmsLink link(port, quick_driver("").patience, stop);
      if (find_lms(link, std::array{baud}).found_baud == baud) return true;
    } catch (const SensorFault&) {
      continue;
    }
  }
  return false;
}

// The sensor falls silent for a while and streams on while the driver rests between two attempts.
TEST(SickLmsTest, LeavesTheSensorInOrderAlsoBetweenTwoAttempts) {
  EmulatorOptions sensor = quick_sensor();
  sensor.faults = {{LmsFaultKind::kSilence, 0.3}};
  sensor.silence_s = 0.5;
  RunningEmulator emulator(sensor);
  SickOptions options = quick_driver(emulator.port());
  options.is_lossless = false;  // nobody takes its scans
  options.patience.pause_s = 1000.0;
  options.patience.close_s = kLeavingPatience.count();
  {
    SickLms laser(options);
    wait_for(laser, "streaming");
    wait_for(laser, "recovering");
    std::this_thread::sleep_for(Seconds(0.6));
  }
  const EmulatedLms& lms = emulator.end();
  EXPECT_EQ(lms.mode(), LmsMode::kOnRequest);
  EXPECT_EQ(lms.baud(), 9600);
}

// The sensor takes 50 ms to say that it changes its baud; meanwhile the driver is stopped.
TEST(SickLmsTest, GivesTheBaudBackAlsoFromAChangeThatIsNotAnsweredYet) {
  for (const double after_s : {0.0, 0.02, 0.04}) {
    EmulatorOptions sensor = quick_sensor();
    sensor.is_paced = true;
    sensor.mode_switch_s = 0.05;
    RunningEmulator emulator(sensor);
    SickOptions options = quick_driver(emulator.port());
    options.patience.close_s = kLeavingPatience.count();
    {
      SickLms laser(options);
      wait_for(laser, "configuring");
      std::this_thread::sleep_for(Seconds(after_s));
    }
    // Of several answers on their way the driver takes the first for its own: the sensor may still be at it.
    EXPECT_TRUE(is_found_at(9600, emulator.port())) << after_s;
  }
}

/// Whatever the driver is at, it stops within 0.2 s. A busy machine makes that longer, never shorter: several
/// drivers are tried.
void expect_quick_stop(const SickOptions& options, const std::string& state, double after_s) {
  double least_s = HUGE_VAL;
  for (int i = 0; i < 8 && least_s > 0.2; ++i) {
    auto laser = std::make_unique<SickLms>(options);
    wait_for(*laser, state);
    std::this_thread::sleep_for(Seconds(after_s));
    const double start_s = steady_now_s();
    laser.reset();
    least_s = std::min(least_s, steady_now_s() - start_s);
  }
  EXPECT_LE(least_s, 0.2) << state;
}

TEST(SickLmsTest, StopsAtOnceWhileItLooksForASensor) {
  PseudoTerminal nobody({});
  SickOptions options;
  options.path = nobody.path();
  for (const double after_s : {0.0, 0.3}) expect_quick_stop(options, "looking for the sensor", after_s);
}

TEST(SickLmsTest, StopsAtOnceWhileItWaitsForASensorThatFellSilent) {
  EmulatorOptions sensor;
  sensor.power_on_baud = 38400;
  sensor.faults = {{LmsFaultKind::kSilence, 0.6}};
  sensor.silence_s = 3600.0;
  RunningEmulator emulator(sensor);
  SickOptions options;
  options.path = emulator.port();
  options.patience.silence_s = 0.1;
  expect_quick_stop(options, "recovering", 0.0);
}

TEST(SickLmsTest, StopsAtOnceWhileItStreams) {
  EmulatorOptions sensor;
  sensor.power_on_baud = 38400;
  RunningEmulator emulator(sensor);
  SickOptions options;
  options.path = emulator.port();
  expect_quick_stop(options, "configuring", 0.0);
  expect_quick_stop(options, "streaming", 0.2);
}

}  // namespace
}  // namespace scanbed::hw
