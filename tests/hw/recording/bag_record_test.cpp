// SPDX-License-Identifier: MIT
#include "hw/recording/bag_record.hpp"

#include <gtest/gtest.h>

#include "core/errors/input_error.hpp"

namespace scanbed::hw {
namespace {

// The bytes that the format's description gives for a message's record.
TEST(BagRecordTest, HasTheBytesOfTheFormat) {
  std::string out;
  append_bag_record(
      out, BagHeader(BagOp::kMessage).field("conn", std::uint32_t{0}).field("time", std::uint64_t{1}), "ab");
  const std::string expected(
      "\x26\0\0\0\x04\0\0\0op=\x02\x09\0\0\0conn=\0\0\0\0\x0d\0\0\0time=\x01\0\0\0\0\0\0\0"
      "\x02\0\0\0ab",
      48);
  EXPECT_EQ(out, expected);
}

TEST(BagRecordTest, FindsFieldsInAnyOrderAndSplitsAtTheFirstEquals) {
  const BagHeader header = BagHeader().field("a", std::string_view("x=y")).field("b", std::uint32_t{7});
  EXPECT_EQ(find_bag_field(header.bytes(), "a"), "x=y");
  EXPECT_EQ(bag_field32(header.bytes(), "b"), 7U);
  EXPECT_FALSE(find_bag_field(header.bytes(), "c").has_value());
}

TEST(BagRecordTest, RefusesMissingFieldsAndOtherWidths) {
  const BagHeader header = BagHeader().field("b", std::uint32_t{7});
  EXPECT_THROW(bag_field64(header.bytes(), "b"), InputError);
  EXPECT_THROW(bag_field32(header.bytes(), "c"), InputError);
  EXPECT_THROW(bag_op(header.bytes()), InputError);
}

TEST(BagRecordTest, HoldsTimesInSecondsAndThenNanoseconds) {
  EXPECT_EQ(to_bag_time(3.5), 3 + (std::uint64_t{500'000'000} << 32U));
  EXPECT_NE(to_bag_time(0.0), 0U);
  for (const double time_s : {0.0, 3.5, 1.0e9}) EXPECT_EQ(from_bag_time(to_bag_time(time_s)), time_s);
}

TEST(BagRecordTest, AFieldBeyondTheHeaderIsNone) {
  std::string bytes = BagHeader().field("a", std::string_view("x")).bytes();
  bytes[0] = '\x7f';
  EXPECT_FALSE(find_bag_field(bytes, "a").has_value());
  EXPECT_FALSE(find_bag_field("\x01\0\0\0a", "a").has_value());
}

}  // namespace
}  // namespace scanbed::hw
