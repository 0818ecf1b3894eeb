// SPDX-License-Identifier: MIT
#include "hw/sick/sick_lms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/errors/input_error.hpp"
#include "core/errors/sensor_fault.hpp"
#include "hw/serial/steady_clock.hpp"
#include "tests/support/running_emulator.hpp"

namespace scanbed::hw {
namespace {

using tests::number_of;
using tests::patient_driver;
using tests::quick_driver;
using tests::quick_sensor;
using tests::quick_sensor_at;
using tests::RunningEmulator;
using Seconds = RangeSensor::Seconds;

// Sanitizers and a busy machine slow everything down; what is tested is not how fast.
constexpr Seconds kPatience{60.0};

double steps_per_m(const SickOptions& options) {
  return options.unit == RangeUnit::kMillimetre ? 1000.0 : 100.0;
}

/// Reads `count` scans; each must be a whole and true one, later than the one before.
void expect_true_scans(SickLms& laser, const SickOptions& options, int count) {
  LaserScan scan;
  std::int64_t last = -1;
  for (int i = 0; i < count; ++i) {
    ASSERT_TRUE(laser.next(scan, kPatience));
    const auto number = number_of(scan, steps_per_m(options));
    ASSERT_TRUE(number.has_value()) << "scan " << i;
    ASSERT_GT(*number, last);
    last = *number;
  }
}

struct Setting {
  int baud;
  int fov_deg;
  int resolution_cdeg;
  RangeUnit unit;
  std::uint8_t address;
};

class SickLmsSettingTest : public ::testing::TestWithParam<Setting> {};

TEST_P(SickLmsSettingTest, StreamsWhatIsAskedFor) {
  const Setting& setting = GetParam();
  EmulatorOptions sensor = quick_sensor();
  sensor.address = setting.address;
  RunningEmulator emulator(sensor);
  SickOptions options = quick_driver(emulator.port());
  options.baud = setting.baud;
  options.fov_deg = setting.fov_deg;
  options.resolution_cdeg = setting.resolution_cdeg;
  options.unit = setting.unit;
  SickLms laser(options);
  expect_true_scans(laser, options, 20);
  LaserScan scan;
  ASSERT_TRUE(laser.next(scan, kPatience));
  EXPECT_EQ(scan.geometry, laser.geometry());
  EXPECT_EQ(scan.num_beams(), setting.fov_deg * 100 / setting.resolution_cdeg + 1);
  EXPECT_EQ(laser.report().num_refused_telegrams, 0);
}

INSTANTIATE_TEST_SUITE_P(All, SickLmsSettingTest,
                         ::testing::Values(Setting{9600, 180, 50, RangeUnit::kMillimetre, 0},
                                           Setting{19200, 180, 100, RangeUnit::kMillimetre, 1},
                                           Setting{38400, 180, 50, RangeUnit::kCentimetre, 1},
                                           Setting{38400, 100, 25, RangeUnit::kMillimetre, 0},
                                           Setting{500000, 100, 50, RangeUnit::kCentimetre, 0},
                                           Setting{500000, 100, 100, RangeUnit::kMillimetre, 1},
                                           Setting{500000, 180, 25, RangeUnit::kMillimetre, 1},
                                           Setting{9600, 180, 25, RangeUnit::kCentimetre, 0}),
                         [](const auto& parameter) {
                           const Setting& s = parameter.param;
                           return "Baud" + std::to_string(s.baud) + "Fov" + std::to_string(s.fov_deg) +
                                  "Step" + std::to_string(s.resolution_cdeg) +
                                  (s.unit == RangeUnit::kMillimetre ? "Mm" : "Cm") + "Address" +
                                  std::to_string(s.address);
                         });

TEST(SickLmsTest, LosesAndDoublesNothing) {
  RunningEmulator emulator(quick_sensor_at(500000));
  SickLms laser(patient_driver(emulator.port()));
  LaserScan scan;
  for (int i = 0; i < 500; ++i) {
    ASSERT_TRUE(laser.next(scan, kPatience));
    ASSERT_EQ(number_of(scan), i);
    ASSERT_EQ(scan.index, i);
  }
}

TEST(SickLmsTest, FindsASensorThatStreamsAtAnotherBaud) {
  EmulatorOptions sensor = quick_sensor();
  sensor.power_on_baud = 19200;
  RunningEmulator emulator(sensor);
  SickOptions options = quick_driver(emulator.port());
  options.restore_baud = false;
  {
    SickLms first(options);
    expect_true_scans(first, options, 3);
  }
  options.baud = 38400;
  SickLms second(options);
  expect_true_scans(second, options, 3);
}

TEST(SickLmsTest, GivesTheSensorItsBaudBackAndStopsTheStream) {
  RunningEmulator emulator(quick_sensor());
  {
    SickOptions options = quick_driver(emulator.port());
    options.patience.close_s = kPatience.count();  // the answer comes within moments, but for a busy machine
    SickLms laser(options);
    expect_true_scans(laser, options, 3);
  }
  const EmulatedLms& lms = emulator.end();
  EXPECT_EQ(lms.baud(), 9600);
  EXPECT_EQ(lms.mode(), LmsMode::kOnRequest);
}

TEST(SickLmsTest, WritesTheConfigurationOnceAndOnlyIfItDiffers) {
  RunningEmulator emulator(quick_sensor_at(500000));
  SickOptions options = patient_driver(emulator.port());
  options.unit = RangeUnit::kCentimetre;
  for (int i = 0; i < 3; ++i) {
    SickLms laser(options);
    expect_true_scans(laser, options, 2);
  }
  EXPECT_EQ(emulator.end().counts().num_eeprom_writes, 1);
}

TEST(SickLmsTest, LeavesAFittingConfigurationAlone) {
  RunningEmulator emulator(quick_sensor());
  {
    const SickOptions options = quick_driver(emulator.port());
    SickLms laser(options);
    expect_true_scans(laser, options, 2);
  }
  EXPECT_EQ(emulator.end().counts().num_eeprom_writes, 0);
}

TEST(SickLmsTest, ReadsEveryMeasuringMode) {
  for (const int mode : {0, 1, 2, 3, 4, 5, 6, 15}) {
    RunningEmulator emulator(quick_sensor_at(500000));
    SickOptions options = patient_driver(emulator.port());
    options.measuring_mode = static_cast<std::uint8_t>(mode);
    SickLms laser(options);
    expect_true_scans(laser, options, 3);
  }
}

TEST(SickLmsTest, TakesIndicesForWhatTheyAre) {
  EmulatorOptions sensor = quick_sensor_at(500000);
  sensor.configuration.set_availability(0x02);
  RunningEmulator emulator(sensor);
  const SickOptions options = patient_driver(emulator.port());
  SickLms laser(options);
  expect_true_scans(laser, options, 10);
}

class SickLmsFaultTest : public ::testing::TestWithParam<LmsFaultKind> {};

TEST_P(SickLmsFaultTest, GivesTrueScansAloneAndResumes) {
  EmulatorOptions sensor = quick_sensor();
  // A port that is not there at the start is an error; one that goes away later is waited for.
  const double first_s = GetParam() == LmsFaultKind::kUnplug ? 0.4 : 0.0;
  for (const double at_s : {first_s, 0.45, 0.8, 0.9}) sensor.faults.push_back({GetParam(), at_s});
  const std::filesystem::path link = ::testing::TempDir() + "lms_" + std::to_string(::getpid());
  RunningEmulator emulator(sensor, tests::numbered_source(), {}, link);
  const SickOptions options = quick_driver(emulator.port());
  SickLms laser(options);
  const double end_s = steady_now_s() + kPatience.count();
  while (emulator.num_faults() < 4 && steady_now_s() < end_s) expect_true_scans(laser, options, 20);
  // After the last fault the stream goes on.
  expect_true_scans(laser, options, 200);
  EXPECT_EQ(emulator.end().counts().num_faults, 4);
}

INSTANTIATE_TEST_SUITE_P(All, SickLmsFaultTest,
                         ::testing::Values(LmsFaultKind::kGarbage, LmsFaultKind::kHalf, LmsFaultKind::kFlip,
                                           LmsFaultKind::kBlindPair, LmsFaultKind::kNak, LmsFaultKind::kMiss,
                                           LmsFaultKind::kSilence, LmsFaultKind::kReboot,
                                           LmsFaultKind::kUnplug, LmsFaultKind::kPollution),
                         [](const auto& parameter) { return std::string(to_string(parameter.param)); });

TEST(SickLmsTest, PassesPollutionOn) {
  EmulatorOptions sensor = quick_sensor();
  sensor.faults = {{LmsFaultKind::kPollution, 0.3}};
  RunningEmulator emulator(sensor);
  SickLms laser(quick_driver(emulator.port()));
  LaserScan scan;
  bool was_polluted = false;
  const double end_s = steady_now_s() + kPatience.count();
  while (!was_polluted && steady_now_s() < end_s) {
    ASSERT_TRUE(laser.next(scan, kPatience));
    was_polluted = scan.health.is_polluted && scan.health.severity == 2;
  }
  EXPECT_TRUE(was_polluted);
}

std::string fault_of(SickLms& laser, SensorFault::Kind& kind) {
  LaserScan scan;
  try {
    laser.next(scan, kPatience);
  } catch (const SensorFault& fault) {
    kind = fault.kind();
    return fault.what();
  }
  return "";
}

TEST(SickLmsTest, ARefusalIsTheEnd) {
  EmulatorOptions sensor = quick_sensor();
  // The first change of mode stops a stream that is none; the second would begin one.
  sensor.faults = {{LmsFaultKind::kRefuse, 0.0}, {LmsFaultKind::kRefuse, 0.0}};
  RunningEmulator emulator(sensor);
  SickOptions options = patient_driver(emulator.port());
  options.baud = 9600;
  SickLms laser(options);
  SensorFault::Kind kind = SensorFault::Kind::kSimulator;
  const std::string message = fault_of(laser, kind);
  EXPECT_EQ(kind, SensorFault::Kind::kProtocol);
  EXPECT_NE(message.find("refused to stream"), std::string::npos) << message;
  EXPECT_EQ(fault_of(laser, kind), message);
}

TEST(SickLmsTest, SaysThatNothingAnswers) {
  PseudoTerminal nobody({});
  SickOptions options = quick_driver(nobody.path());
  options.patience.num_first_attempts = 1;
  SickLms laser(options);
  SensorFault::Kind kind = SensorFault::Kind::kSimulator;
  const std::string message = fault_of(laser, kind);
  // No timeout: asking again would not help.
  EXPECT_EQ(kind, SensorFault::Kind::kDisconnected);
  EXPECT_NE(message.find(nobody.path() + ": nothing answers at 9600"), std::string::npos) << message;
}

TEST(SickLmsTest, SaysThatThereIsNoSuchPort) {
  SickLms laser(quick_driver("/dev/no_such_port"));
  SensorFault::Kind kind = SensorFault::Kind::kSimulator;
  const std::string message = fault_of(laser, kind);
  EXPECT_EQ(kind, SensorFault::Kind::kDisconnected);
  EXPECT_NE(message.find("/dev/no_such_port: no such port"), std::string::npos) << message;
}

TEST(SickLmsTest, SaysThatAPortIsInUse) {
  RunningEmulator emulator(quick_sensor_at(500000));
  const SickOptions options = patient_driver(emulator.port());
  SickLms first(options);
  expect_true_scans(first, options, 1);
  SickLms second(options);
  SensorFault::Kind kind = SensorFault::Kind::kSimulator;
  const std::string message = fault_of(second, kind);
  EXPECT_NE(message.find("in use"), std::string::npos) << message;
}

TEST(SickLmsTest, TimesOutWithoutEndingTheStream) {
  EmulatorOptions sensor = quick_sensor();
  sensor.faults = {{LmsFaultKind::kSilence, 0.3}};
  sensor.silence_s = 1.0;
  RunningEmulator emulator(sensor);
  const SickOptions options = quick_driver(emulator.port());
  SickLms laser(options);
  LaserScan scan;
  bool has_timed_out = false;
  const double end_s = steady_now_s() + kPatience.count();
  while (!has_timed_out && steady_now_s() < end_s) {
    try {
      laser.next(scan, Seconds(0.2));
    } catch (const SensorFault& fault) {
      ASSERT_EQ(fault.kind(), SensorFault::Kind::kTimeout) << fault.what();
      has_timed_out = true;
    }
  }
  EXPECT_TRUE(has_timed_out);
  expect_true_scans(laser, options, 5);
}

TEST(SickLmsTest, StopEndsTheStream) {
  RunningEmulator emulator(quick_sensor());
  const SickOptions options = quick_driver(emulator.port());
  SickLms laser(options);
  expect_true_scans(laser, options, 2);
  laser.stop();
  LaserScan scan;
  EXPECT_FALSE(laser.next(scan, kPatience));
  EXPECT_FALSE(laser.next(scan, kPatience));
}

// At 38400 baud a telegram of 732 bytes takes 0.19 s, and a scan 20 ms.
TEST(SickLmsTest, ScansComeAtTheLinksRateWithTheTimeOfTheirFirstBeam) {
  EmulatorOptions sensor;
  sensor.power_on_baud = 38400;
  sensor.mode_switch_s = 0.01;
  RunningEmulator emulator(sensor);
  SickOptions options = patient_driver(emulator.port());
  options.baud = 38400;
  SickLms laser(options);
  // A busy machine makes single scans late: a few in a row that were not are enough.
  int num_in_time = 0;
  LaserScan scan;
  ASSERT_TRUE(laser.next(scan, kPatience));
  for (int i = 0; i < 100 && num_in_time < 3; ++i) {
    const double last_s = scan.time_s;
    ASSERT_TRUE(laser.next(scan, kPatience));
    num_in_time = std::abs(scan.time_s - last_s - 9 * 0.02664) < 0.01 ? num_in_time + 1 : 0;
  }
  EXPECT_EQ(num_in_time, 3);
}

// This sensor does not keep to its baud, at which a telegram alone would take 0.76 s.
TEST(SickLmsTest, NoTimeIsNegative) {
  RunningEmulator emulator(quick_sensor());
  SickOptions options = patient_driver(emulator.port());
  options.baud = 9600;
  SickLms laser(options);
  LaserScan scan;
  double last_s = 0.0;
  for (int i = 0; i < 20; ++i) {
    ASSERT_TRUE(laser.next(scan, kPatience));
    EXPECT_GT(scan.time_s, last_s);
    last_s = scan.time_s;
  }
}

TEST(SickLmsTest, RefusesBadOptions) {
  SickOptions options = quick_driver("/dev/null");
  options.baud = 115200;
  EXPECT_THROW(SickLms{options}, InputError);
}

}  // namespace
}  // namespace scanbed::hw
