// SPDX-License-Identifier: MIT
#include "hw/recording/recording_format.hpp"

#include <gtest/gtest.h>

namespace scanbed::hw {
namespace {

TEST(RecordingFormatTest, NamesTellTheFormat) {
  EXPECT_EQ(format_of_name("a/b.log"), RecordingFormat::kCarmen);
  EXPECT_EQ(format_of_name("b.clf.gz"), RecordingFormat::kCarmen);
  EXPECT_EQ(format_of_name("b.plog"), RecordingFormat::kPlayer);
  EXPECT_EQ(format_of_name("b.player"), RecordingFormat::kPlayer);
  EXPECT_EQ(format_of_name("b.bag"), RecordingFormat::kBag);
  EXPECT_EQ(format_of_name("b.mcap.part"), RecordingFormat::kMcap);
  EXPECT_EQ(format_of_name("b.jsonl.gz"), RecordingFormat::kJsonLines);
  for (const char* name : {"", "b", "b.txt", "b.gz", "b.bag.gz", "b.mcap.gz", ".log", "log/"}) {
    EXPECT_FALSE(format_of_name(name).has_value()) << name;
  }
  EXPECT_TRUE(is_packed_name("b.log.gz"));
  EXPECT_FALSE(is_packed_name("b.log"));
}

TEST(RecordingFormatTest, ContentTellsTheFormat) {
  EXPECT_EQ(format_of_content("#ROSBAG V2.0\nx"), RecordingFormat::kBag);
  EXPECT_EQ(format_of_content("\x89MCAP0\r\n"), RecordingFormat::kMcap);
  EXPECT_EQ(format_of_content(R"({"format":"scanbed.recording","version":1)"), RecordingFormat::kJsonLines);
  EXPECT_EQ(format_of_content(R"( { "version": 1, "format" : "scanbed.recording")"),
            RecordingFormat::kJsonLines);
  EXPECT_EQ(format_of_content("# x\n\n0000001000.000 16777343 6665 laser 00 004 001 0\n"),
            RecordingFormat::kPlayer);
  EXPECT_EQ(format_of_content("# x\r\nFLASER 3 1 2 3 0 0 0 0 0 0 1 h 1\r\n"), RecordingFormat::kCarmen);
  EXPECT_EQ(format_of_content("PARAM a b nohost 0\n1.0"), RecordingFormat::kCarmen);
  EXPECT_EQ(format_of_content("\xEF\xBB\xBFSYNC x\n"), RecordingFormat::kCarmen);
  EXPECT_EQ(format_of_content("\xEF\xBB\xBF{\"format\":\"scanbed.recording\""), RecordingFormat::kJsonLines);
  for (const char* text :
       {"", "#", "# a\n# b\n", "FLASER 3 1 2", "0000001000.000 16777343 6665 laser 00 004 001", "{}",
        "1.0 1 1 laser x 1 1\n", "1 2 3\n", "Dear Sir\n"}) {
    EXPECT_FALSE(format_of_content(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace scanbed::hw
