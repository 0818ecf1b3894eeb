// SPDX-License-Identifier: MIT
#include "hw/scip/scip_text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace scanbed::hw {
namespace {

TEST(ScipTextTest, SumsAreThoseOfTheSpecification) {
  for (const auto& [body, sum] : {std::pair{"00", 'P'},
                                  {"99", 'b'},
                                  {"01", 'Q'},
                                  {"10", 'Q'},
                                  {"0A", 'a'},
                                  {"0E", 'e'},
                                  {"0M", 'm'},
                                  {"0000", '0'},
                                  {"00?X", 'g'},
                                  {"oooo", 'l'},
                                  {"ARES:1024", '\\'},
                                  {"CBoo07", ':'}}) {
    EXPECT_EQ(scip_sum(body), sum) << body;
  }
}

TEST(ScipTextTest, NumbersAreThoseOfTheSpecification) {
  EXPECT_EQ(encode_scip(1234, 2), "CB");
  EXPECT_EQ(encode_scip(5432, 3), "1Dh");
  EXPECT_EQ(encode_scip(1000, 3), "0?X");
  EXPECT_EQ(encode_scip(30000, 3), "7D`");
  EXPECT_EQ(encode_scip(60000, 3), ">YP");
  EXPECT_EQ(encode_scip(65533, 3), "?om");
  EXPECT_EQ(encode_scip(16000000, 4), "m2@0");
  EXPECT_EQ(decode_scip("ooo"), 262143);
  EXPECT_EQ(decode_scip("JUGn"), 6968830);
  EXPECT_EQ(decode_scip("0p0"), std::nullopt);
  EXPECT_EQ(decode_scip("0/0"), std::nullopt);
}

TEST(ScipTextTest, LinesLoseTheirSumIfItIsRight) {
  EXPECT_EQ(strip_sum("00?Xg"), "00?X");
  EXPECT_EQ(strip_sum("00?Xh"), std::nullopt);
  EXPECT_EQ(strip_sum("0?X0?Y0?ZI"), std::nullopt);
  EXPECT_EQ(strip_sum(""), std::nullopt);
}

TEST(ScipTextTest, ValuesStraddleBlocks) {
  std::string data;
  for (int i = 0; i < 22; ++i) data += "0?X";
  EXPECT_EQ(to_scip_blocks(data), data.substr(0, 64) + "3\n?XG\n");
  EXPECT_EQ(to_scip_blocks("0?X0?Y0?Z"), "0?X0?Y0?ZH\n");
  EXPECT_EQ(to_scip_blocks("0?X0O@0?Y0OA"), "0?X0O@0?Y0OA>\n");
  EXPECT_EQ(join_scip_blocks({data.substr(0, 64) + "3", "?XG"}), data);
  EXPECT_EQ(join_scip_blocks({data.substr(0, 64) + "4", "?XG"}), std::nullopt);
}

TEST(ScipTextTest, MessagesEndAtAnEmptyLine) {
  ScipReader reader;
  std::vector<std::string> lines;
  reader.feed("QT\n00P\n");
  EXPECT_FALSE(reader.next(lines));
  reader.feed("\nMD\n99b\n\n");
  ASSERT_TRUE(reader.next(lines));
  EXPECT_EQ(lines, (std::vector<std::string>{"QT", "00P"}));
  ASSERT_TRUE(reader.next(lines));
  EXPECT_EQ(lines, (std::vector<std::string>{"MD", "99b"}));
  EXPECT_FALSE(reader.next(lines));
}

TEST(ScipTextTest, AnEndlessMessageIsDropped) {
  ScipReader reader;
  std::vector<std::string> lines;
  for (int i = 0; i < 3000; ++i) reader.feed(std::string(64, 'x') + "\n");
  EXPECT_FALSE(reader.next(lines));
  reader.feed("\nQT\n00P\n\n");
  while (reader.next(lines) && lines.front() != "QT") continue;
  EXPECT_EQ(lines.back(), "00P");
}

RC_GTEST_PROP(ScipTextTest, NumbersComeBack, ()) {
  const auto value = *rc::gen::inRange<std::int64_t>(0, 1 << 24);
  RC_ASSERT(decode_scip(encode_scip(value, 4)) == value);
}

RC_GTEST_PROP(ScipTextTest, MessagesAreTheSameHoweverTheyArrive, ()) {
  const std::string bytes = "QT\n00P\n\nPP\n00P\nDMIN:23;7\n\nxx\n\n";
  ScipReader reader;
  std::vector<std::vector<std::string>> all;
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < bytes.size();) {
    const auto count = *rc::gen::inRange<std::size_t>(1, 8);
    reader.feed(std::string_view(bytes).substr(at, count));
    at += count;
    while (reader.next(lines)) all.push_back(lines);
  }
  RC_ASSERT(all ==
            (std::vector<std::vector<std::string>>{{"QT", "00P"}, {"PP", "00P", "DMIN:23;7"}, {"xx"}}));
}

}  // namespace
}  // namespace scanbed::hw
