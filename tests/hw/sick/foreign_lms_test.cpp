// SPDX-License-Identifier: MIT
// The driver and a sensor that shares no code with it, in all settings, with all habits that the protocol
// leaves open, and with faults.
#include "tests/support/foreign_lms.hpp"

#include <gtest/gtest.h>

#include "core/errors/sensor_fault.hpp"
#include "hw/sick/sick_lms.hpp"
#include "tests/support/running_emulator.hpp"

namespace scanbed::hw {
namespace {

using tests::ForeignFault;
using tests::ForeignHabits;
using tests::ForeignLms;
using Seconds = RangeSensor::Seconds;

constexpr Seconds kHostPatience{30.0};

/// Reads `count` scans: each whole, true and later than the one before. Returns the last.
LaserScan read_true_scans(SickLms& laser, const SickOptions& options, int count) {
  LaserScan scan;
  std::int64_t last = -1;
  const double steps_per_m = options.unit == RangeUnit::kMillimetre ? 1000.0 : 100.0;
  for (int i = 0; i < count; ++i) {
    EXPECT_TRUE(laser.next(scan, kHostPatience));
    const auto number = tests::number_of(scan, steps_per_m);
    EXPECT_TRUE(number.has_value()) << "scan " << i;
    EXPECT_EQ(scan.num_beams(), options.variant().num_beams());
    if (!number || ::testing::Test::HasFailure()) return scan;
    EXPECT_GT(*number, last);
    last = *number;
  }
  return scan;
}

struct BaudAndAddress {
  int baud;
  std::uint8_t address;
};

class ForeignSettingTest : public ::testing::TestWithParam<BaudAndAddress> {};

TEST_P(ForeignSettingTest, StreamsInEveryVariantAndUnit) {
  struct Variant {
    int fov_deg;
    int resolution_cdeg;
  };
  for (const Variant& variant : {Variant{180, 100}, {180, 50}, {180, 25}, {100, 100}, {100, 50}, {100, 25}}) {
    for (const RangeUnit unit : {RangeUnit::kMillimetre, RangeUnit::kCentimetre}) {
      ForeignHabits habits;
      habits.reply_address = GetParam().address;
      // Once found at another baud, once at the wanted one.
      habits.power_on_baud = unit == RangeUnit::kMillimetre ? 9600 : GetParam().baud;
      ForeignLms sensor(habits);
      SickOptions options = tests::quick_driver(sensor.port());
      options.baud = GetParam().baud;
      options.fov_deg = variant.fov_deg;
      options.resolution_cdeg = variant.resolution_cdeg;
      options.unit = unit;
      SickLms laser(options);
      read_true_scans(laser, options, 5);
      EXPECT_EQ(sensor.baud(), options.baud);
      ASSERT_FALSE(HasFailure()) << variant.fov_deg << " degrees at " << variant.resolution_cdeg
                                 << (unit == RangeUnit::kMillimetre ? " mm" : " cm");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ForeignSettingTest,
                         ::testing::Values(BaudAndAddress{9600, 0x80}, BaudAndAddress{9600, 0x81},
                                           BaudAndAddress{19200, 0x80}, BaudAndAddress{19200, 0x81},
                                           BaudAndAddress{38400, 0x80}, BaudAndAddress{38400, 0x81},
                                           BaudAndAddress{500000, 0x80}, BaudAndAddress{500000, 0x81}),
                         [](const auto& parameter) {
                           return "Baud" + std::to_string(parameter.param.baud) + "Address" +
                                  std::to_string(parameter.param.address);
                         });

struct Habit {
  const char* name;
  ForeignHabits habits;
};

void PrintTo(const Habit& habit, std::ostream* out) {
  *out << habit.name;
}

/// The driver as users have it, but that it drops nothing.
SickOptions plain_driver(const ForeignLms& sensor) {
  SickOptions options;
  options.path = sensor.port();
  options.is_lossless = true;
  return options;
}

class ForeignHabitTest : public ::testing::TestWithParam<Habit> {};

TEST_P(ForeignHabitTest, IsUnderstood) {
  ForeignLms sensor(GetParam().habits);
  const SickOptions options = plain_driver(sensor);
  SickLms laser(options);
  const LaserScan scan = read_true_scans(laser, options, 5);
  EXPECT_EQ(scan.health.severity, GetParam().habits.status & 0x07);
  EXPECT_EQ(scan.health.is_polluted, (GetParam().habits.status & 0x80) != 0);
  EXPECT_EQ(scan.health.is_implausible, (GetParam().habits.status & 0x40) != 0);
  // The EEPROM is written where it must be, and once.
  const bool must_write = !GetParam().habits.is_in_millimetres || GetParam().habits.measuring_mode == 0x3F;
  EXPECT_EQ(sensor.num_writes(), must_write ? 1 : 0);
}

INSTANTIATE_TEST_SUITE_P(
    All, ForeignHabitTest,
    ::testing::Values(
        Habit{"Plain", {}}, Habit{"AsItComes", {.power_on_baud = 9600}},
        Habit{"SlowAck", {.ack_s = 0.06, .reply_s = 0.05}},
        Habit{"NoAck", {.acknowledges = false, .reply_s = 0.05}},
        Habit{"AckBehindReply", {.acknowledges_late = true}}, Habit{"SlowModes", {.mode_s = 0.6}},
        Habit{"SlowWrite", {.is_in_millimetres = false, .write_s = 1.5}},
        Habit{"OneBaud", {.bauds = {38400}}}, Habit{"AtAnyBaud", {.power_on_baud = 19200}},
        Habit{"AtTheFastest", {.power_on_baud = 500000}},
        Habit{"InPieces", {.piece_bytes = 5, .piece_s = 0.0005}},
        Habit{"StandsStillInTelegrams", {.piece_bytes = 500, .piece_s = 0.12}},
        Habit{"ByteByByte", {.piece_bytes = 1}}, Habit{"Warning", {.status = 0xD2}},
        Habit{"Fatal", {.status = 0x54}}, Habit{"NoDiagnostics", {.knows_diagnostics = false}},
        Habit{"PowerOnText", {.power_on_baud = 9600, .status = 0x13, .says_power_on = true}},
        Habit{"Streaming", {.power_on_baud = 500000, .streams_at_power_on = true, .breaks_off = true}},
        Habit{"StreamingAmidNoise",
              {.power_on_baud = 19200, .talks_at_other_bauds = true, .streams_at_power_on = true}},
        Habit{"StreamBeforeReply", {.streams_before_reply = true}},
        Habit{"OldConfiguration", {.configuration_bytes = 32, .is_in_millimetres = false}},
        Habit{"LongConfiguration", {.configuration_bytes = 36, .is_in_millimetres = false}},
        Habit{"OwnWayToWrite", {.changes_other_bytes = true, .is_in_millimetres = false}},
        Habit{"Indices", {.sends_indices = true}}, Habit{"Reflectivity", {.measuring_mode = 0x3F}},
        Habit{"Mode1", {.measuring_mode = 1}}, Habit{"Mode2", {.measuring_mode = 2}},
        Habit{"Mode3", {.measuring_mode = 3}}, Habit{"Mode4", {.measuring_mode = 4}},
        Habit{"Mode5", {.measuring_mode = 5}}, Habit{"Mode6", {.measuring_mode = 6}},
        Habit{"ModeF", {.measuring_mode = 0x0F}}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

TEST(ForeignLmsTest, TurnsMayComeInAnotherOrder) {
  ForeignLms sensor({.sends_indices = true, .sends_turns_out_of_order = true});
  SickOptions options = plain_driver(sensor);
  options.resolution_cdeg = 25;
  SickLms laser(options);
  read_true_scans(laser, options, 5);
}

class ForeignFaultTest : public ::testing::TestWithParam<ForeignFault> {};

TEST_P(ForeignFaultTest, InTheStreamIsSurvived) {
  for (const int resolution_cdeg : {50, 25}) {
    ForeignLms sensor({.power_on_baud = 9600, .reply_address = 0x81});
    SickOptions options = tests::quick_driver(sensor.port());
    options.resolution_cdeg = resolution_cdeg;
    SickLms laser(options);
    read_true_scans(laser, options, 3);
    for (int i = 0; i < 3; ++i) {
      sensor.arm(GetParam());
      std::thread reader([&] { read_true_scans(laser, options, 300); });
      EXPECT_TRUE(sensor.has_failed());
      reader.join();
      ASSERT_FALSE(HasFailure());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ForeignFaultTest,
                         ::testing::Values(ForeignFault::kFlip, ForeignFault::kHalf, ForeignFault::kGarbage,
                                           ForeignFault::kBlindHeadPair, ForeignFault::kOtherUnit,
                                           ForeignFault::kShort, ForeignFault::kSilence,
                                           ForeignFault::kReboot, ForeignFault::kUnplug));

class ForeignRequestFaultTest : public ::testing::TestWithParam<ForeignFault> {};

TEST_P(ForeignRequestFaultTest, IsAskedAgain) {
  ForeignLms sensor({});
  sensor.arm(GetParam());
  const SickOptions options = plain_driver(sensor);
  SickLms laser(options);
  EXPECT_TRUE(sensor.has_failed());
  read_true_scans(laser, options, 5);
}

INSTANTIATE_TEST_SUITE_P(All, ForeignRequestFaultTest,
                         ::testing::Values(ForeignFault::kNak, ForeignFault::kDeaf, ForeignFault::kLostAck));

std::string failure_of(SickLms& laser) {
  LaserScan scan;
  try {
    while (laser.next(scan, kHostPatience)) continue;
  } catch (const SensorFault& fault) {
    return fault.what();
  }
  return "";
}

TEST(ForeignLmsTest, ABaudThatItDoesNotTakeIsNamed) {
  ForeignLms sensor({.power_on_baud = 9600, .bauds = {9600}});
  SickLms laser(plain_driver(sensor));
  EXPECT_NE(failure_of(laser).find("refused 38400 baud"), std::string::npos) << failure_of(laser);
}

TEST(ForeignLmsTest, AnotherPasswordIsNamedAndNothingWritten) {
  ForeignLms sensor({.password = "OTHER_PW", .is_in_millimetres = false});
  SickLms laser(plain_driver(sensor));
  EXPECT_NE(failure_of(laser).find("password"), std::string::npos) << failure_of(laser);
  EXPECT_EQ(sensor.num_writes(), 0);
}

}  // namespace
}  // namespace scanbed::hw
