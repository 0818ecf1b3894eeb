// SPDX-License-Identifier: MIT
#include "hw/sick/crc.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/hex.hpp"

namespace scanbed::hw {
namespace {

using tests::from_hex;

/// The manufacturer's definition, byte by byte.
std::uint16_t slow_crc(ByteView bytes) {
  std::uint16_t crc = 0;
  std::uint16_t previous = 0;
  for (const std::uint8_t byte : bytes) {
    const bool carry = (crc & 0x8000) != 0;
    crc = static_cast<std::uint16_t>(crc << 1);
    if (carry) crc ^= 0x8005;
    crc ^= static_cast<std::uint16_t>(byte | (previous << 8));
    previous = byte;
  }
  return crc;
}

TEST(LmsCrcTest, IsThatOfPrintedTelegrams) {
  EXPECT_EQ(lms_crc(from_hex("02 00 01 00 31")), 0x1215);
  EXPECT_EQ(lms_crc(from_hex("02 00 0A 00 20 00 53 49 43 4B 5F 4C 4D 53")), 0xC5BE);
}

TEST(LmsCrcTest, NothingHasCheckWordZero) {
  EXPECT_EQ(lms_crc({}), 0);
}

RC_GTEST_PROP(LmsCrcTest, IsTheDefinitionForAnyBytes, (const Bytes& bytes)) {
  RC_ASSERT(lms_crc(bytes) == slow_crc(bytes));
}

RC_GTEST_PROP(LmsCrcTest, NoticesEverySingleFlippedBit, ()) {
  Bytes bytes = *rc::gen::nonEmpty<Bytes>();
  const std::uint16_t before = lms_crc(bytes);
  const auto at = *rc::gen::inRange<std::size_t>(0, bytes.size());
  bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ (1 << *rc::gen::inRange(0, 8)));
  RC_ASSERT(lms_crc(bytes) != before);
}

// The reason why lengths and contents are checked as well.
TEST(LmsCrcTest, MissesABitAndItsNeighbourInTheNextByte) {
  Bytes bytes = from_hex("02 80 0C 00 B0 04 40 E8 03 FE 1F FF 1F D0 27 10");
  const std::uint16_t before = lms_crc(bytes);
  bytes[8] ^= 0x01;
  bytes[9] ^= 0x02;
  EXPECT_EQ(lms_crc(bytes), before);
}

}  // namespace
}  // namespace scanbed::hw
