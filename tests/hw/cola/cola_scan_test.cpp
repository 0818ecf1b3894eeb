// SPDX-License-Identifier: MIT
#include "hw/cola/cola_scan.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace scanbed::hw {
namespace {

const std::string kTim551 =
    "sSN LMDscandata 1 1 107375C 0 0 1 1 1E4A 31D2 0 0 8 0 0 5DC 36 0 1 DIST1 3F800000 00000000 FFF92230 "
    "2710 5 3E8 "
    "3E9 3EA 3EB 3EC 0 0 1 B not defined 0 0 0";

TEST(ColaScanTest, ReadsATelegramOfATim551) {
  const auto telegram = parse_cola_scan(kTim551);
  ASSERT_TRUE(telegram.has_value());
  EXPECT_EQ(telegram->start_us, 7754u);
  EXPECT_EQ(telegram->sent_us, 12754u);
  EXPECT_EQ(telegram->frequency_chz, 1500u);
  ASSERT_EQ(telegram->channels.size(), 1u);
  LaserScan scan;
  ASSERT_TRUE(to_laser_scan(*telegram, scan));
  EXPECT_EQ(scan.range_m, (std::vector<double>{1.000, 1.001, 1.002, 1.003, 1.004}));
  EXPECT_NEAR(degrees(scan.geometry.bearing_rad(0)), -135.0, 1e-9);
  EXPECT_NEAR(degrees(scan.geometry.bearing_rad(4)), -131.0, 1e-9);
}

TEST(ColaScanTest, ReadsRemissionBesideRanges) {
  const auto telegram = parse_cola_scan(
      "sRA LMDscandata 1 1 107375C 0 0 2AD8 2ADD 7907F6FD 79080660 0 0 1 0 0 5DC 36 0 1 DIST1 3F800000 "
      "00000000 "
      "FFF92230 2710 3 116 120 123 1 RSSI1 3F800000 00000000 FFF92230 2710 3 9A 9D 9D 0 1 B not defined 0 0 "
      "0");
  ASSERT_TRUE(telegram.has_value());
  ASSERT_EQ(telegram->channels.size(), 2u);
  EXPECT_EQ(telegram->channels[1].values, (std::vector<std::uint32_t>{154, 157, 157}));
  LaserScan scan;
  ASSERT_TRUE(to_laser_scan(*telegram, scan));
  EXPECT_EQ(scan.range_m, (std::vector<double>{0.278, 0.288, 0.291}));
}

TEST(ColaScanTest, ReadsEncodersAndTwoChannelsOf16Bits) {
  const auto telegram = parse_cola_scan(
      "sSN LMDscandata 1 1 89A27F 0 0 1 1 27477BA9 27478F31 0 0 7 0 0 1388 168 1 0 3E8 2 DIST1 3F800000 "
      "00000000 0 "
      "1388 3 3E8 3E9 3EA RSSI1 3F800000 00000000 0 1388 3 64 65 66 0 1 00000000 00000000 00000000 00000000 "
      "00000000 "
      "00000000 0 1 B not defined 0 0 0");
  ASSERT_TRUE(telegram.has_value());
  ASSERT_EQ(telegram->channels.size(), 2u);
  EXPECT_EQ(telegram->channels[1].name, "RSSI1");
}

std::string telegram_of(const std::string& status, const std::string& channel) {
  return "sSN LMDscandata 1 1 1 0 " + status + " 1 1 0 0 0 0 0 0 0 1388 168 0 1 " + channel + " 0 0 0 0 0 0";
}

TEST(ColaScanTest, AgeIsFromTheStartOfTheScanToItsTransmission) {
  // As printed by a real TiM: 79080660h - 7907F6FDh.
  EXPECT_NEAR((ColaScan{.start_us = 0x7907F6FD, .sent_us = 0x79080660}).age_s(), 3939e-6, 1e-12);
  EXPECT_NEAR((ColaScan{.start_us = 0xFFFFFF00, .sent_us = 0x00000100}).age_s(), 512e-6, 1e-12);
  EXPECT_EQ((ColaScan{.start_us = 7, .sent_us = 7}).age_s(), 0.0);
  EXPECT_EQ((ColaScan{.start_us = 7, .sent_us = 1'000'007}).age_s(), 1.0);
  // Sensors that do not tell.
  EXPECT_EQ((ColaScan{.start_us = 7754, .sent_us = 0}).age_s(), 0.0);
  EXPECT_EQ((ColaScan{.start_us = 7754, .sent_us = 7753}).age_s(), 0.0);
}

TEST(ColaScanTest, ScalesAndLeavesCodesOut) {
  LaserScan scan;
  const auto far = parse_cola_scan(telegram_of("0", "DIST1 40000000 00000000 0 1388 4 7D0 0 3 F"));
  ASSERT_TRUE(far && to_laser_scan(*far, scan));
  EXPECT_EQ(scan.range_m, (std::vector<double>{4.0, kNoEcho, kNoEcho, kNoEcho}));
}

TEST(ColaScanTest, AThirdOfADegreeIsAWholeThird) {
  std::string values;
  for (int i = 0; i < 811; ++i) values += " 3E8";
  LaserScan scan;
  const auto tim571 = parse_cola_scan(telegram_of("0", "DIST1 3F800000 00000000 FFF92230 D05 32B" + values));
  ASSERT_TRUE(tim571 && to_laser_scan(*tim571, scan));
  EXPECT_NEAR(degrees(scan.geometry.bearing_rad(810)), 135.0, 1e-9);
}

TEST(ColaScanTest, StatusIsHealth) {
  LaserScan scan;
  for (const auto& [status, severity, is_polluted] :
       {std::tuple{"0", 0, false}, {"1", 3, false}, {"2", 2, true}, {"5", 3, true}}) {
    const auto telegram = parse_cola_scan(telegram_of(status, "DIST1 3F800000 00000000 0 1388 1 3E8"));
    ASSERT_TRUE(telegram && to_laser_scan(*telegram, scan));
    EXPECT_EQ(scan.health.severity, severity);
    EXPECT_EQ(scan.health.is_polluted, is_polluted);
  }
}

TEST(ColaScanTest, RefusesWhatIsCutOffBeforeItsValuesEnd) {
  const std::size_t end_of_values = kTim551.find(" 0 0 1 B not");
  for (std::size_t size = 0; size < end_of_values; ++size) {
    const auto telegram = parse_cola_scan(kTim551.substr(0, size));
    // The last value may have lost a digit; no earlier cut goes unnoticed.
    EXPECT_TRUE(!telegram || size >= end_of_values - 2) << size;
  }
  EXPECT_TRUE(parse_cola_scan(kTim551.substr(0, end_of_values)).has_value());
}

TEST(ColaScanTest, RefusesChannelsThatCannotBe) {
  LaserScan scan;
  EXPECT_FALSE(parse_cola_scan(telegram_of("0", "DIST1 3F800000 00000000 0 1388 FFFF 1")).has_value());
  for (const char* channel : {"RSSI1 3F800000 00000000 0 1388 1 64", "DIST1 3F800000 00000000 0 0 1 64",
                              "DIST1 7FC00000 00000000 0 1388 1 64", "DIST1 00000000 00000000 0 1388 1 64"}) {
    const auto telegram = parse_cola_scan(telegram_of("0", channel));
    ASSERT_TRUE(telegram.has_value());
    EXPECT_FALSE(to_laser_scan(*telegram, scan)) << channel;
  }
}

RC_GTEST_PROP(ColaScanTest, TakesAnyText, (const std::string& text)) {
  LaserScan scan;
  const auto telegram = parse_cola_scan("sSN LMDscandata " + text);
  RC_ASSERT(!telegram || telegram->channels.size() <= 32);
  if (telegram) to_laser_scan(*telegram, scan);
}

}  // namespace
}  // namespace scanbed::hw
