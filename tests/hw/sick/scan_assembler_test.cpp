// SPDX-License-Identifier: MIT
#include "hw/sick/scan_assembler.hpp"

#include <gtest/gtest.h>

namespace scanbed::hw {
namespace {

using Outcome = ScanAssembler::Outcome;

Bytes whole(std::size_t count, int value, std::uint8_t status = 0x10) {
  ScanTelegram telegram;
  telegram.words.assign(count, static_cast<std::uint16_t>(value));
  telegram.status.bits = status;
  return encode(telegram);
}

/// A turn whose values are its place in quarters of a degree, beyond `base`.
Bytes turn(int partial, int base, std::uint8_t status = 0x10) {
  ScanTelegram telegram;
  telegram.is_partial = true;
  telegram.partial = partial;
  telegram.status.bits = status;
  for (int i = 0; i < partial_size(partial); ++i) {
    telegram.words.push_back(static_cast<std::uint16_t>(base + 4 * i + partial));
  }
  return encode(telegram);
}

SickOptions interlaced() {
  SickOptions options;
  options.resolution_cdeg = 25;
  return options;
}

TEST(ScanAssemblerTest, MakesAScanOfATelegram) {
  ScanAssembler assembler({}, {}, false);
  LaserScan scan;
  ASSERT_EQ(assembler.take(whole(361, 1234, 0x92), {1.0}, scan), Outcome::kScan);
  EXPECT_EQ(scan.num_beams(), 361);
  EXPECT_EQ(scan.range_m[17], 1.234);
  EXPECT_EQ(scan.geometry, assembler.geometry());
  EXPECT_LT(scan.time_s, 1.0);
  EXPECT_TRUE(scan.health.is_polluted);
}

TEST(ScanAssemblerTest, RefusesWhatWasNotConfigured) {
  ScanAssembler assembler({}, {}, false);
  LaserScan scan;
  EXPECT_EQ(assembler.take(whole(181, 1), {1.0}, scan), Outcome::kRefused);
  EXPECT_EQ(assembler.take(turn(0, 0), {1.0}, scan), Outcome::kRefused);
  EXPECT_EQ(assembler.take({}, {1.0}, scan), Outcome::kRefused);
}

TEST(ScanAssemblerTest, PutsFourTurnsTogether) {
  ScanAssembler assembler(interlaced(), {}, false);
  LaserScan scan;
  for (int i = 0; i < 3; ++i) EXPECT_EQ(assembler.take(turn(i, 1000), {1.0 + i}, scan), Outcome::kPart);
  ASSERT_EQ(assembler.take(turn(3, 1000, 0x92), {4.0}, scan), Outcome::kScan);
  ASSERT_EQ(scan.num_beams(), 721);
  for (int i = 0; i < 721; ++i) EXPECT_EQ(scan.range_m[static_cast<std::size_t>(i)], (1000 + i) / 1000.0);
  EXPECT_LT(scan.time_s, 1.0);
  EXPECT_TRUE(scan.health.is_polluted);
}

// At 38400 baud a turn takes 97 ms to send: every ninth is sent.
TEST(ScanAssemblerTest, BeamsOfTurnsThatASlowLinkSendsHaveTheirTimes) {
  ScanAssembler assembler(interlaced(), {}, false);
  LaserScan scan;
  double arrival_s = 1.0;
  const auto take_scan = [&](double turn_s, std::initializer_list<int> order) {
    for (const int i : order) assembler.take(turn(i, 0), {arrival_s += turn_s}, scan);
    return scan.geometry.timing.offset_s(3) - scan.geometry.timing.offset_s(0);
  };
  EXPECT_NEAR(take_scan(9 * 0.01332 + 0.001, {0, 1, 2, 3}), 27 * 0.01332, 1e-12);
  EXPECT_NEAR(take_scan(0.01332, {0, 1, 2, 3}), 3 * 0.01332, 1e-12);
}

TEST(ScanAssemblerTest, TakesTurnsInTheOrderOfASlowLink) {
  ScanAssembler assembler(interlaced(), {}, false);
  LaserScan scan;
  for (const int i : {0, 3, 2}) EXPECT_EQ(assembler.take(turn(i, 0), {1.0}, scan), Outcome::kPart);
  EXPECT_EQ(assembler.take(turn(1, 0), {1.0}, scan), Outcome::kScan);
}

TEST(ScanAssemblerTest, MixesNoTurnsOfTwoScans) {
  ScanAssembler assembler(interlaced(), {}, false);
  LaserScan scan;
  // Begins in the middle of a scan; then turn 2 gets lost, and the next scan begins.
  for (const int i : {1, 2, 3, 0, 1}) EXPECT_EQ(assembler.take(turn(i, 1000), {1.0}, scan), Outcome::kPart);
  EXPECT_EQ(assembler.take(turn(3, 1000), {1.0}, scan), Outcome::kPart);
  for (const int i : {0, 1, 2}) EXPECT_EQ(assembler.take(turn(i, 2000), {2.0}, scan), Outcome::kPart);
  ASSERT_EQ(assembler.take(turn(3, 2000), {2.0}, scan), Outcome::kScan);
  EXPECT_EQ(scan.range_m[2], 2.002);
}

TEST(ScanAssemblerTest, ForgetsTurnsWhenTold) {
  ScanAssembler assembler(interlaced(), {}, false);
  LaserScan scan;
  for (const int i : {0, 1}) assembler.take(turn(i, 1000), {1.0}, scan);
  assembler.forget_turns();
  for (const int i : {2, 3}) EXPECT_EQ(assembler.take(turn(i, 2000), {1.0}, scan), Outcome::kPart);
  for (const int i : {0, 1, 2}) EXPECT_EQ(assembler.take(turn(i, 3000), {1.0}, scan), Outcome::kPart);
  EXPECT_EQ(assembler.take(turn(3, 3000), {1.0}, scan), Outcome::kScan);
}

}  // namespace
}  // namespace scanbed::hw
