// SPDX-License-Identifier: MIT
#include "hw/recording/mcap_record.hpp"

#include <gtest/gtest.h>

namespace scanbed::hw {
namespace {

// The check value of this CRC in every catalogue.
TEST(McapRecordTest, CrcIsThatOfZlib) {
  EXPECT_EQ(mcap_crc(0, "123456789"), 0xcbf43926U);
  EXPECT_EQ(mcap_crc(mcap_crc(0, "1234"), "56789"), 0xcbf43926U);
  EXPECT_EQ(mcap_crc(0, ""), 0U);
}

// The smallest header of the format's description: profile "", library "x".
TEST(McapRecordTest, HasTheBytesOfTheFormat) {
  std::string content;
  append_mcap_text(content, "");
  append_mcap_text(content, "x");
  std::string out;
  append_mcap_record(out, McapOp::kHeader, content);
  EXPECT_EQ(out, std::string("\x01\x09\0\0\0\0\0\0\0\0\0\0\0\x01\0\0\0x", 18));
}

TEST(McapRecordTest, MapsComeBack) {
  const std::map<std::string, std::string> map = {{"a", ""}, {"b", "c"}};
  std::string bytes;
  append_mcap_map(bytes, map);
  ByteCursor cursor(bytes);
  EXPECT_EQ(read_mcap_map(cursor), map);
  EXPECT_TRUE(cursor.ok());
  EXPECT_EQ(cursor.num_left(), 0U);
}

TEST(McapRecordTest, AMapThatDoesNotAddUpFails) {
  std::string bytes;
  append_mcap_map(bytes, {{"a", "b"}});
  bytes[0] = '\x09';
  ByteCursor cursor(bytes);
  read_mcap_map(cursor);
  EXPECT_FALSE(cursor.ok());
}

}  // namespace
}  // namespace scanbed::hw
