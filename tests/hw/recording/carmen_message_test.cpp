// SPDX-License-Identifier: MIT
#include "hw/recording/carmen_message.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "core/errors/input_error.hpp"
#include "core/geometry/angles.hpp"

namespace scanbed::hw {
namespace {

using Kind = CarmenLine::Kind;

// One line of each message, as CARMEN's logger writes them, cut down to a few readings.
constexpr const char* kFlaser = "FLASER 3 1.50 2.25 0.75 0.1 0.2 0.3 10 20 1.5 976052857.25 nohost 0.125";
constexpr const char* kRawLaser =
    "RAWLASER2 0 -1.5 3.0 1.5 50 0.01 0 3 1.50 60.00 0.75 2 17 18 976052857.25 magnum 0.125";
constexpr const char* kRobotLaser =
    "ROBOTLASER1 0 -1.5 3.0 1.5 81.9 0.01 0 3 1.5 2.25 0.75 0 0.1 0.2 0.3 10 20 1.5 0.4 0.05 0.3 0.2 1e10 "
    "976052857.25 magnum 0.125";
constexpr const char* kOldRobotLaser =
    "ROBOTLASER2 0 -1.5 3.0 1.5 81.9 0.01 0 3 1.5 2.25 0.75 0.1 0.2 0.3 10 20 1.5 0.4 0.05 0.3 0.2 "
    "976052857.25 magnum 0.125";

LaserScan scan_of(const std::string& line, const CarmenLogOptions& options = {}) {
  LaserScan scan;
  const CarmenLine read = parse_carmen_line(line, options, scan);
  EXPECT_EQ(read.kind, Kind::kScan) << line << "\n" << read.damage;
  return scan;
}

std::string damage_of(const std::string& line) {
  LaserScan scan;
  const CarmenLine read = parse_carmen_line(line, {}, scan);
  EXPECT_EQ(read.kind, Kind::kDamaged) << line;
  return read.damage;
}

Kind kind_of(const std::string& line, const CarmenLogOptions& options = {}) {
  LaserScan scan;
  return parse_carmen_line(line, options, scan).kind;
}

std::string flaser(int num_readings) {
  std::string line = "FLASER " + std::to_string(num_readings);
  for (int i = 0; i < num_readings; ++i) line += " 1";
  return line + " 0 0 0 0 0 0 1 host 1";
}

/// FLASER with three readings, one of them `reading`.
double range_of(const std::string& reading, const CarmenLogOptions& options = {}) {
  return scan_of("FLASER 3 1 " + reading + " 1 0 0 0 0 0 0 1 host 1", options).range_m.at(1);
}

void expect_pose(const std::optional<Pose2>& X_OR, double x_m, double y_m, double theta_rad) {
  ASSERT_TRUE(X_OR.has_value());
  EXPECT_EQ(X_OR->p_m.x(), x_m);
  EXPECT_EQ(X_OR->p_m.y(), y_m);
  EXPECT_EQ(X_OR->theta_rad, theta_rad);
}

TEST(CarmenMessageTest, ReadsFlaser) {
  const LaserScan scan = scan_of(kFlaser);
  EXPECT_EQ(scan.source, "FLASER");
  EXPECT_EQ(scan.time_s, 976052857.25);
  EXPECT_EQ(scan.range_m, (std::vector<double>{1.5, 2.25, 0.75}));
  EXPECT_EQ(scan.geometry.num_beams, 3);
  EXPECT_EQ(scan.geometry.max_range_m, 81.83);
  expect_pose(scan.X_OR, 10, 20, 1.5);  // the odometry, not the corrected pose in front of it
}

TEST(CarmenMessageTest, ReadsRlaserLikeFlaser) {
  std::string line = kFlaser;
  line[0] = 'R';
  const LaserScan scan = scan_of(line);
  EXPECT_EQ(scan.source, "RLASER");
  EXPECT_EQ(scan.range_m, scan_of(kFlaser).range_m);
  expect_pose(scan.X_OR, 10, 20, 1.5);
}

TEST(CarmenMessageTest, ReadsRawLaser) {
  const LaserScan scan = scan_of(kRawLaser);
  EXPECT_EQ(scan.source, "RAWLASER2");
  EXPECT_EQ(scan.time_s, 976052857.25);
  EXPECT_EQ(scan.range_m, (std::vector<double>{1.5, kNoEcho, 0.75}));  // 60 lies beyond its maximum of 50
  EXPECT_EQ(scan.geometry.first_rad, -1.5);
  EXPECT_EQ(scan.geometry.step_rad, 1.5);
  EXPECT_EQ(scan.geometry.max_range_m, 50.0);
  EXPECT_FALSE(scan.X_OR.has_value());
}

TEST(CarmenMessageTest, ReadsRobotLaser) {
  const LaserScan scan = scan_of(kRobotLaser);
  EXPECT_EQ(scan.source, "ROBOTLASER1");
  EXPECT_EQ(scan.time_s, 976052857.25);
  EXPECT_EQ(scan.range_m, (std::vector<double>{1.5, 2.25, 0.75}));
  EXPECT_EQ(scan.geometry.first_rad, -1.5);
  EXPECT_EQ(scan.geometry.step_rad, 1.5);
  expect_pose(scan.X_OR, 10, 20, 1.5);
}

TEST(CarmenMessageTest, ReadsRobotLaserWithRemissions) {
  std::string line = kRobotLaser;
  line.replace(line.find(" 0 0.1"), 2, " 3 11 12 13");
  expect_pose(scan_of(line).X_OR, 10, 20, 1.5);
}

TEST(CarmenMessageTest, ReadsRobotLaserOfOlderLogs) {
  const LaserScan scan = scan_of(kOldRobotLaser);
  EXPECT_EQ(scan.source, "ROBOTLASER2");
  EXPECT_EQ(scan.time_s, 976052857.25);
  expect_pose(scan.X_OR, 10, 20, 1.5);
}

TEST(CarmenMessageTest, KnowsAllEightLasers) {
  std::string raw = kRawLaser;
  for (const char number : {'1', '2', '3', '4'}) {
    raw[8] = number;
    EXPECT_EQ(scan_of(raw).source, raw.substr(0, 9));
  }
  raw[8] = '5';
  EXPECT_EQ(kind_of(raw), Kind::kOther);
  std::string robot = kRobotLaser;
  robot[10] = '2';
  EXPECT_EQ(scan_of(robot).source, "ROBOTLASER2");
  robot[10] = '3';
  EXPECT_EQ(kind_of(robot), Kind::kOther);
}

TEST(CarmenMessageTest, TheTailMayBeMissing) {
  for (const std::string line : {kFlaser, kRawLaser, kRobotLaser}) {
    LaserScan scan;
    scan.time_s = 7.0;
    const CarmenLine read = parse_carmen_line(line.substr(0, line.find(" 976052857")), {}, scan);
    EXPECT_EQ(read.kind, Kind::kScan) << line << read.damage;
    EXPECT_FALSE(read.has_time);
    EXPECT_EQ(scan.time_s, 7.0);
    EXPECT_TRUE(parse_carmen_line(line, {}, scan).has_time);
  }
}

TEST(CarmenMessageTest, GuessesAnLmsFromTheNumberOfReadings) {
  struct Case {
    int num_beams;
    double first_deg, step_deg;
  };
  // LMS 2xx: 180 degrees at 1 and 0.5, 100 degrees at 0.25; CARMEN drops the last beam of each in some logs.
  constexpr std::array kCases = {Case{361, -90, 0.5},  Case{360, -90, 0.5},  Case{181, -90, 1},
                                 Case{180, -90, 1},    Case{401, -50, 0.25}, Case{400, -50, 0.25},
                                 Case{721, -90, 0.25}, Case{3, -90, 90},     Case{2, -90, 180}};
  for (const Case& expected : kCases) {
    const ScanGeometry geometry = scan_of(flaser(expected.num_beams)).geometry;
    EXPECT_EQ(geometry.num_beams, expected.num_beams);
    EXPECT_NEAR(degrees(geometry.first_rad), expected.first_deg, 1e-12) << expected.num_beams;
    EXPECT_NEAR(degrees(geometry.step_rad), expected.step_deg, 1e-12) << expected.num_beams;
  }
}

TEST(CarmenMessageTest, AScanMayHaveNoBeamOrOne) {
  EXPECT_EQ(scan_of(flaser(0)).num_beams(), 0);
  EXPECT_EQ(scan_of(flaser(1)).num_beams(), 1);
  EXPECT_TRUE(std::isfinite(scan_of(flaser(1)).geometry.step_rad));
}

TEST(CarmenMessageTest, ReadingsBecomeRangesByRep117) {
  EXPECT_EQ(range_of("81.82"), 81.82);
  EXPECT_EQ(range_of("81.83"), kNoEcho);
  EXPECT_EQ(range_of("81.91"), kNoEcho);
  EXPECT_EQ(range_of("inf"), kNoEcho);
  EXPECT_EQ(range_of("0"), kTooClose);
  EXPECT_EQ(range_of("-0.0"), kTooClose);
  EXPECT_EQ(range_of("-inf"), kTooClose);
  EXPECT_TRUE(std::isnan(range_of("-0.5")));
  EXPECT_TRUE(std::isnan(range_of("nan")));
  EXPECT_EQ(range_of("0.001"), 0.001);
}

TEST(CarmenMessageTest, TheNoReturnLimitCanBeSet) {
  EXPECT_EQ(range_of("11.0", {.only = "", .no_return_m = 11.0}), kNoEcho);
  EXPECT_EQ(range_of("100", {.only = "", .no_return_m = 200.0}), 100.0);
}

// The LMS's codes end at 81.91 m: who can measure farther has none of them.
TEST(CarmenMessageTest, AMaximumRangeBeyondTheLmsCodesIsWhatCounts) {
  const auto first_range_m = [](const std::string& max_range, const CarmenLogOptions& options = {}) {
    LaserScan scan;
    const CarmenLine line =
        parse_carmen_line("RAWLASER1 0 -0.5 1 0.5 " + max_range + " 0.01 0 3 90 81.85 7 0", options, scan);
    EXPECT_EQ(line.kind, CarmenLine::Kind::kScan) << line.damage;
    return scan.range_m.at(0);
  };
  EXPECT_EQ(first_range_m("200"), 90.0);
  EXPECT_EQ(first_range_m("90"), kNoEcho);
  EXPECT_EQ(first_range_m("81.9"), kNoEcho);
  EXPECT_EQ(first_range_m("0"), kNoEcho);
  EXPECT_EQ(first_range_m("200", {.only = "", .no_return_m = 81.83}), kNoEcho);
}

TEST(CarmenMessageTest, AMaximumRangeOfZeroOrInfinityIsNone) {
  for (const char* range : {" 0 0.01", " inf 0.01", " nan 0.01", " -1 0.01"}) {
    std::string line = kRawLaser;
    line.replace(line.find(" 50 0.01"), 8, range);
    EXPECT_EQ(scan_of(line).range_m.at(1), 60.0) << range;
  }
}

TEST(CarmenMessageTest, AFieldOfViewReplacesAMissingResolution) {
  const LaserScan scan = scan_of("RAWLASER1 0 -1 2 0 50 0.01 0 5 1 1 1 1 1 0");
  EXPECT_EQ(scan.geometry.step_rad, 0.5);
}

TEST(CarmenMessageTest, OdometryThatIsNotFiniteIsNone) {
  EXPECT_FALSE(scan_of("FLASER 1 1 0 0 0 nan 0 0 1 host 1").X_OR.has_value());
}

TEST(CarmenMessageTest, HeadingsAreWrapped) {
  EXPECT_NEAR(scan_of("FLASER 1 1 0 0 0 0 0 7 1 host 1").X_OR->theta_rad, 7.0 - 2.0 * kPi, 1e-15);
}

TEST(CarmenMessageTest, OtherLinesCarryNoScan) {
  EXPECT_EQ(kind_of("# FLASER num_readings [range_readings]"), Kind::kOther);
  EXPECT_EQ(kind_of("PARAM robot_width 0.3 nohost 0"), Kind::kOther);
  EXPECT_EQ(kind_of("ODOM 0 0 0 0 0 0 1 host 1"), Kind::kOther);
  EXPECT_EQ(kind_of("LASER3 1 1 1 host 1"), Kind::kOther);
  EXPECT_EQ(kind_of("FLASER2 1 1"), Kind::kOther);
  EXPECT_EQ(kind_of("flaser 1 1"), Kind::kOther);
  EXPECT_EQ(kind_of(""), Kind::kBlank);
  EXPECT_EQ(kind_of(" \t"), Kind::kBlank);
}

TEST(CarmenMessageTest, OneMessageCanBeAskedForAlone) {
  EXPECT_EQ(kind_of(kFlaser, {.only = "FLASER"}), Kind::kScan);
  EXPECT_EQ(kind_of(kFlaser, {.only = "RLASER"}), Kind::kOther);
}

TEST(CarmenMessageTest, NamesWhatIsWrongWithALine) {
  EXPECT_EQ(damage_of("FLASER"), "FLASER: num_readings is missing");
  EXPECT_EQ(damage_of("FLASER x"), "FLASER: num_readings is 'x', not a count");
  EXPECT_EQ(damage_of("FLASER -5 1"), "FLASER: num_readings is '-5', not a count");
  EXPECT_EQ(damage_of("FLASER 1000000000 1 2"),
            "FLASER: 1000000000 readings announced, but 2 fields left on the line");
  EXPECT_EQ(damage_of("FLASER 2 1 abc 0 0 0 0 0 0 1 host 1"), "FLASER: a reading is 'abc', not a number");
  EXPECT_EQ(damage_of("FLASER 2 1 2 0 0 0 0 0 0 nan host 1"), "FLASER: ipc_timestamp is not finite");
  EXPECT_EQ(damage_of("FLASER 2 1 2 0 0 0 0 0 0 -1e308 host 1"),
            "FLASER: ipc_timestamp is more than 1e12 s away from 0");
  EXPECT_EQ(damage_of("RAWLASER1 0 nan 3 1.5 50 0.01 0 0 0"), "RAWLASER1: start_angle is not finite");
  EXPECT_EQ(damage_of("RAWLASER1 0 -90 180 0.5 50 0.01 0 1 1 0"),
            "RAWLASER1: the first beam's angle is more than a turn, in radians");
  EXPECT_EQ(damage_of("RAWLASER1 0 0 0 0 50 0.01 0 2 1 1 0"), "RAWLASER1: all beams point the same way");
  EXPECT_EQ(damage_of("RAWLASER1 0 -1 1 7 50 0.01 0 2 1 1 0"),
            "RAWLASER1: the beams are spread over more than a turn, in radians");
  EXPECT_EQ(damage_of("RAWLASER1 0 -1 1 0.5 50 0.01 0 2 1 1 2147483647 1"),
            "RAWLASER1: wrong number of fields: 1 left after 2 readings");
  EXPECT_EQ(damage_of("RAWLASER1 0 -1 1 0.5 50 0.01 0 2 1 1"), "RAWLASER1: num_remissions is missing");
}

TEST(CarmenMessageTest, ALineWithZeroBytesIsDamaged) {
  EXPECT_EQ(damage_of(std::string("FLASER 1 1\0", 11)), "holds zero bytes");
  EXPECT_EQ(damage_of(std::string(100, '\0')), "holds zero bytes");
}

TEST(CarmenMessageTest, AReadingLostOrDoubledIsSeen) {
  for (const std::string line : {kFlaser, kRawLaser, kRobotLaser, kOldRobotLaser}) {
    std::string lost = line;
    lost.replace(lost.find(" 1.5"), lost.find(' ', lost.find(" 0.75") + 1) - lost.find(" 1.5"), " 1.5 0.75");
    EXPECT_EQ(kind_of(lost), Kind::kDamaged) << lost;
    std::string doubled = line;
    doubled.insert(doubled.find(" 0.75"), " 0.75");
    EXPECT_EQ(kind_of(doubled), Kind::kDamaged) << doubled;
  }
}

TEST(CarmenMessageTest, ALineCutAnywhereIsAScanOnlyWhereItsTailBegan) {
  for (const std::string line : {kFlaser, kRawLaser, kRobotLaser, kOldRobotLaser}) {
    const std::size_t tail = line.find(" 976052857");
    const std::size_t last_field = line.rfind(' ');
    const std::size_t before_tail = line.rfind(' ', tail - 1);
    for (std::size_t size = 0; size < line.size(); ++size) {
      // A cut within the last number of either form leaves a shorter number, which no reader can tell.
      const bool may_be_scan = size > last_field + 1 || (size > before_tail + 1 && size <= tail + 1);
      if (may_be_scan) continue;
      EXPECT_NE(kind_of(line.substr(0, size)), Kind::kScan) << line.substr(0, size);
    }
  }
}

TEST(CarmenMessageTest, OptionsAreValidated) {
  EXPECT_NO_THROW(CarmenLogOptions{}.validate());
  EXPECT_NO_THROW(CarmenLogOptions{.only = "RAWLASER4"}.validate());
  EXPECT_THROW((CarmenLogOptions{.only = "", .no_return_m = 0.0}.validate()), InputError);
  EXPECT_THROW((CarmenLogOptions{.only = "", .no_return_m = NAN}.validate()), InputError);
  try {
    CarmenLogOptions{.only = "LASER3"}.validate();
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "log.only: 'LASER3' is no laser message; allowed: FLASER RLASER RAWLASER1 RAWLASER2 RAWLASER3 "
        "RAWLASER4 ROBOTLASER1 ROBOTLASER2");
  }
}

std::string printed(double value) {
  std::array<char, 40> text = {};
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

/// What CARMEN's logger would write for the scan, with all digits.
std::string written(const LaserScan& scan, const std::vector<int>& remissions) {
  std::string line = "ROBOTLASER1 0 " + printed(scan.geometry.first_rad) + " 3 " +
                     printed(scan.geometry.step_rad) + " " + printed(scan.geometry.max_range_m) + " 0.01 0 " +
                     std::to_string(scan.num_beams());
  for (const double range_m : scan.range_m) line += " " + printed(range_m);
  line += " " + std::to_string(remissions.size());
  for (const int remission : remissions) line += " " + std::to_string(remission);
  line += " 0 0 0 " + printed(scan.X_OR->p_m.x()) + " " + printed(scan.X_OR->p_m.y()) + " " +
          printed(scan.X_OR->theta_rad) + " 0 0 0 0 0 " + printed(scan.time_s) + " host 0";
  return line;
}

double number_in(int low, int high, double step) {
  return *rc::gen::inRange(low, high) * step;
}

TEST(CarmenMessageTest, GivesBackWhatWasWritten) {
  EXPECT_TRUE(rc::check([] {
    LaserScan scan;
    const auto millimetres = *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 49000));
    for (const int range_mm : millimetres) scan.range_m.push_back(range_mm * 0.001);
    scan.geometry.num_beams = scan.num_beams();
    scan.geometry.first_rad = number_in(-3000, 3000, 0.001);
    scan.geometry.step_rad = number_in(1, 1000, 1e-3) / (scan.num_beams() + 1);
    scan.geometry.max_range_m = 50.0;
    scan.X_OR = Pose2{{number_in(-100000, 100000, 1e-3), number_in(-100000, 100000, 1e-3)},
                      number_in(-3141, 3141, 1e-3)};
    scan.time_s = number_in(0, 1000000000, 0.001);

    const LaserScan read = scan_of(written(scan, *rc::gen::arbitrary<std::vector<int>>()));
    RC_ASSERT(read.range_m == scan.range_m);
    RC_ASSERT(read.geometry == scan.geometry);
    RC_ASSERT(read.geometry.max_range_m == scan.geometry.max_range_m);
    RC_ASSERT(read.time_s == scan.time_s);
    RC_ASSERT(read.X_OR->p_m == scan.X_OR->p_m);
    RC_ASSERT(read.X_OR->theta_rad == scan.X_OR->theta_rad);
  }));
}

}  // namespace
}  // namespace scanbed::hw
