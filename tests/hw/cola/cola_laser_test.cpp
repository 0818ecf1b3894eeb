// SPDX-License-Identifier: MIT
#include "hw/cola/cola_laser.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "core/errors/input_error.hpp"
#include "hw/cola/emulated_cola.hpp"
#include "hw/serial/steady_clock.hpp"
#include "tests/support/interposed_device.hpp"
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
  options.poll_s = 0.01;
  options.recovery.pause_s = 0.05;
  return options;
}

/// A driver that soon gives up.
ColaOptions impatient(int port) {
  ColaOptions options = network(port);
  options.reply_s = 1.0;
  options.recovery.num_first_attempts = 1;
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

// The emulated sensor sends a scan 4 ms after its start, as a TiM does: it cannot be younger when it is here.
TEST(ColaLaserTest, TimesAreThoseOfTheMeasurement) {
  WideSensor source;
  EmulatedCola sensor({.num_spin_up_polls = 0}, source);
  RunningDevice running(sensor);
  const double before_s = steady_now_s();
  const auto laser = open_cola(network(running.port()));
  // Times begin one second before the laser was opened.
  constexpr double kOpened_s = 1.0;
  LaserScan scan;
  double last_s = kOpened_s - 0.004;
  for (int i = 0; i < 50; ++i) {
    ASSERT_TRUE(laser->next(scan, kPatience));
    EXPECT_LE(scan.time_s, steady_now_s() - before_s + kOpened_s - 0.004);
    EXPECT_GE(scan.time_s, last_s);
    last_s = scan.time_s;
  }
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

TEST(ColaLaserTest, ARefusedPasswordIsTheEndWhereTheMotorStandsStill) {
  WideSensor source;
  EmulatedCola sensor({.num_spin_up_polls = 1000000, .refuses_password = true}, source);
  RunningDevice running(sensor);
  ColaOptions options = network(running.port());
  options.spin_up_s = 0.1;
  const auto laser = open_cola(options);
  LaserScan scan;
  EXPECT_THROW(laser->next(scan, kPatience), DeviceRefusal);
}

TEST(ColaLaserTest, WaitsForTheMotorAlsoWhereTheLogInIsRefused) {
  WideSensor source;
  EmulatedCola sensor({.is_paced = false, .num_spin_up_polls = 5, .refuses_password = true}, source);
  RunningDevice running(sensor);
  const auto laser = open_cola(network(running.port()));
  expect_true_scans(*laser, 5, 541);
}

/// An emulated sensor that answers one request with an error, or not at all where there is none, for some
/// times; lists all requests.
class RefusingCola final : public tests::InterposedDevice {
 public:
  RefusingCola(ByteDevice& sensor, std::string request, std::string error, int num_times)
      : InterposedDevice(sensor),
        request_(std::move(request)),
        error_(std::move(error)),
        num_times_(num_times) {}

  void receive(ByteView bytes, double now_s) override {
    reader_.feed(bytes);
    for (std::string body; reader_.next(body);) {
      requests.push_back(body);
      const bool is_refused = body.starts_with(request_) && num_refused < num_times_;
      if (is_refused && !error_.empty()) refuse();
      num_refused += is_refused ? 1 : 0;
      if (!is_refused) hand_on(frame_cola(body), now_s);
    }
  }

  std::atomic<int> num_refused = 0;
  std::vector<std::string> requests;  // to be read when nobody serves it any more

 private:
  void refuse() {
    const Bytes error = frame_cola(error_);
    answer({reinterpret_cast<const char*>(error.data()), error.size()});
  }

  std::string request_;
  std::string error_;
  int num_times_;
  ColaReader reader_;
};

/// What a driver says when it gives up on a sensor.
std::string last_words_on(ByteDevice& sensor) {
  RunningDevice running(sensor);
  const auto laser = open_cola(impatient(running.port()));
  LaserScan scan;
  try {
    laser->next(scan, kPatience);
  } catch (const SensorFault& fault) {
    return fault.what();
  }
  return "none";
}

// While somebody is logged in, an LMS sends nothing to anybody.
TEST(ColaLaserTest, LogsOutAlsoWhereItGivesUp) {
  WideSensor source;
  EmulatedCola emulated({}, source);
  RefusingCola sensor(emulated, "sMN LMCstartmeas", "", 1);
  EXPECT_NE(last_words_on(sensor).find("no answer to sMN LMCstartmeas"), std::string::npos);
  ASSERT_GE(sensor.requests.size(), 2U);
  EXPECT_EQ(sensor.requests[sensor.requests.size() - 2], "sMN Run");
  EXPECT_EQ(sensor.requests.back(), "sEN LMDscandata 0");
}

TEST(ColaLaserTest, AsksABusySensorAgain) {
  for (const char* request : {"sMN SetAccessMode", "sWN LMDscandatacfg", "sMN LMCstartmeas", "sMN Run",
                              "sRN STlms", "sEN LMDscandata 1"}) {
    WideSensor source;
    EmulatedCola emulated({.is_paced = false}, source);
    RefusingCola sensor(emulated, request, "sFA D", 2);
    RunningDevice running(sensor);
    const auto laser = open_cola(network(running.port()));
    expect_true_scans(*laser, 2, 541);
    EXPECT_EQ(sensor.num_refused, 2) << request;
  }
}

// As one that speaks CoLa B does with what it takes for noise.
TEST(ColaLaserTest, SaysWhatMayBeWrongWhereNothingIsAnswered) {
  WideSensor source;
  EmulatedCola emulated({}, source);
  RefusingCola sensor(emulated, "s", "", 1000);
  EXPECT_NE(last_words_on(sensor).find("does it speak CoLa A here"), std::string::npos);
}

TEST(ColaLaserTest, AsksNoMoreWhereTheSensorDoesNotKnowItsScans) {
  WideSensor source;
  EmulatedCola emulated({}, source);
  RefusingCola sensor(emulated, "sEN LMDscandata 1", "sFA F", 1);
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
  ColaOptions options = network(2111);
  options.poll_s = 0.0;
  EXPECT_THROW(open_cola(options), InputError);
}

}  // namespace
}  // namespace scanbed::hw
