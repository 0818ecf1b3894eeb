// SPDX-License-Identifier: MIT
#include "hw/recording/line_reader.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <string>
#include <utility>

#include "tests/support/gzip.hpp"

namespace scanbed::hw {
namespace {

constexpr std::size_t kMaxLine = LineReader::kMaxLine;

std::vector<std::string> lines_of(std::string text) {
  LineReader reader(from_memory(std::move(text)));
  std::vector<std::string> lines;
  for (TextLine line; reader.next(line);) {
    lines.emplace_back(line.text);
    EXPECT_EQ(line.number, static_cast<std::int64_t>(lines.size()));
    EXPECT_FALSE(line.is_too_long);
  }
  return lines;
}

using Lines = std::vector<std::string>;

TEST(LineReaderTest, CutsAtLineEndsOfBothKinds) {
  EXPECT_EQ(lines_of("one\ntwo\r\n\nfour\n"), (Lines{"one", "two", "", "four"}));
}

TEST(LineReaderTest, TheLastLineMayLackItsEnd) {
  EXPECT_EQ(lines_of("one\ntwo"), (Lines{"one", "two"}));
  EXPECT_EQ(lines_of("one\r"), (Lines{"one"}));
}

TEST(LineReaderTest, AByteOrderMarkIsNoPartOfTheFirstLine) {
  EXPECT_EQ(lines_of("\xEF\xBB\xBFone\n\xEF\xBB\xBFtwo\n"), (Lines{"one", "\xEF\xBB\xBFtwo"}));
  EXPECT_EQ(lines_of("\xEF\xBB\xBF"), (Lines{""}));
}

TEST(LineReaderTest, NothingHoldsNoLine) {
  EXPECT_EQ(lines_of(""), Lines{});
  EXPECT_EQ(lines_of("\n"), Lines{""});
}

TEST(LineReaderTest, KeepsZeroBytesAndLoneReturns) {
  EXPECT_EQ(lines_of(std::string("a\0b\rc\n", 6)), Lines{std::string("a\0b\rc", 5)});
}

TEST(LineReaderTest, ALineMayHaveExactlyTheGreatestLength) {
  const std::string longest(kMaxLine, 'x');
  EXPECT_EQ(lines_of(longest + "\nnext\n"), (Lines{longest, "next"}));
  EXPECT_EQ(lines_of(longest + "\r\nnext\n"), (Lines{longest, "next"}));
  EXPECT_EQ(lines_of(longest), Lines{longest});
}

TEST(LineReaderTest, SkipsTheRestOfALineThatIsTooLong) {
  for (const std::size_t num_over : {std::size_t{1}, std::size_t{2}, std::size_t{3}, 2 * kMaxLine}) {
    for (const std::string end : {"\n", "\r\n"}) {
      LineReader reader(from_memory("first\n" + std::string(kMaxLine + num_over, 'x') + end + "third\n"));
      TextLine line;
      ASSERT_TRUE(reader.next(line));
      ASSERT_TRUE(reader.next(line));
      EXPECT_TRUE(line.is_too_long);
      EXPECT_EQ(line.number, 2);
      EXPECT_EQ(line.text, std::string(kMaxLine, 'x'));
      ASSERT_TRUE(reader.next(line));
      EXPECT_FALSE(line.is_too_long);
      EXPECT_EQ(line.text, "third");
      EXPECT_FALSE(reader.next(line));
      EXPECT_FALSE(reader.next(line));
    }
  }
}

TEST(LineReaderTest, ALineThatIsTooLongMayBeTheLast) {
  LineReader reader(from_memory(std::string(2 * kMaxLine, 'x')));
  TextLine line;
  ASSERT_TRUE(reader.next(line));
  EXPECT_TRUE(line.is_too_long);
  EXPECT_FALSE(reader.next(line));
}

TEST(LineReaderTest, OfCutOffDataGivesCompleteLinesOnly) {
  const std::string text = "one\ntwo\nthree, which is not complete\n";
  const std::string packed = tests::gzip(text);
  LineReader reader(unpack(from_memory(packed.substr(0, packed.size() - 9))));
  std::string all;
  for (TextLine line; reader.next(line);) all += std::string(line.text) + "\n";
  EXPECT_EQ(reader.end(), StreamEnd::kCutOff);
  EXPECT_TRUE(text.starts_with(all));
  EXPECT_TRUE(all.starts_with("one\ntwo\n")) << all;
}

TEST(LineReaderTest, GivesBackWhateverLinesWereJoined) {
  EXPECT_TRUE(rc::check([](const std::vector<std::string>& raw) {
    Lines lines;
    std::string text;
    for (std::string line : raw) {
      std::erase_if(line, [](char c) { return c == '\n' || c == '\r'; });
      text += line + "\n";
      lines.push_back(line);
    }
    RC_ASSERT(lines_of(text) == lines);
  }));
}

}  // namespace
}  // namespace scanbed::hw
