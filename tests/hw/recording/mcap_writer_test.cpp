// SPDX-License-Identifier: MIT
#include "hw/recording/mcap_writer.hpp"

#include <gtest/gtest.h>

#include "hw/recording/mcap_record.hpp"
#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

// Offsets as the format's description states them: the footer's 20 bytes stand before the magic.
TEST(McapWriterTest, TheSummaryIsWhereTheFooterSaysAndHasItsChecksum) {
  const std::string bytes = recorded("x.mcap", made_scans(3), {{"seed", "7"}});
  ASSERT_TRUE(bytes.ends_with(kMcapMagic));
  const std::size_t footer = bytes.size() - 8 - 20;
  ByteCursor cursor(std::string_view(bytes).substr(footer, 20));
  const auto start = cursor.number<std::uint64_t>();
  const auto offsets = cursor.number<std::uint64_t>();
  EXPECT_EQ(cursor.number<std::uint32_t>(),
            mcap_crc(0, std::string_view(bytes).substr(start, footer + 16 - start)));
  EXPECT_EQ(bytes[start], '\x03');
  EXPECT_EQ(bytes[offsets], '\x0e');
  EXPECT_EQ(bytes[start - 13], '\x0f');  // DataEnd stands directly before the summary
  ByteCursor data_end(std::string_view(bytes).substr(start - 4, 4));
  EXPECT_EQ(data_end.number<std::uint32_t>(), mcap_crc(0, std::string_view(bytes).substr(0, start - 13)));
}

TEST(McapWriterTest, EachChunkIsReadableWithoutTheOthers) {
  std::string bytes = recorded("x.mcap", made_scans(10));
  bytes[2000] ^= 0x10;  // in the first of three chunks: four scans
  const Reading reading = read_all(bytes, "x.mcap");
  ASSERT_EQ(reading.scans.size(), 6U) << reading.error;
  EXPECT_EQ(reading.scans[0].range_m[0], made_scan(4).range_m[0]);
}

// As after kill -9: the file ends where the last chunk ended.
TEST(McapWriterTest, ChunksOfEachSecondAreReadableBeforeTheEnd) {
  const TemporaryFolder folder;
  const auto writer = create_recording(folder / "x.mcap", {{"seed", "7"}});
  for (const LaserScan& scan : made_scans(10)) writer->write({.scan = scan});
  const Reading reading = read_all(bytes_of(folder / "x.mcap.part"), "x.mcap.part");
  EXPECT_EQ(reading.scans.size(), 8U);  // four a second, the third second is open
  EXPECT_EQ(reading.metadata.at("seed"), "7");
  EXPECT_NE(reading.error.find("is not finished"), std::string::npos);
}

TEST(McapWriterTest, SameScansSameBytes) {
  EXPECT_EQ(recorded("x.mcap", made_scans(5)), recorded("x.mcap", made_scans(5)));
}

// MCAP's texts are UTF-8, whatever the names were that another recording gave to its lasers.
TEST(McapWriterTest, NamesThatAreNoUtf8AreReplaced) {
  LaserScan scan = made_scan(0);
  scan.source = "front\xff";
  const std::string bytes = recorded("x.mcap", {scan}, {{"note", "\xe4"}});
  const Reading reading = read_all(bytes, "x.mcap");
  ASSERT_EQ(reading.scans.size(), 1U) << reading.error;
  EXPECT_EQ(reading.scans[0].source, "front\xef\xbf\xbd");
  EXPECT_EQ(reading.metadata.at("note"), "\xef\xbf\xbd");
  EXPECT_NE(bytes.find("/front\xef\xbf\xbd"), std::string::npos);
}

TEST(McapWriterTest, FeaturesAndTruthComeBack) {
  const TemporaryFolder folder;
  const auto writer = create_recording(folder / "x.mcap", {});
  const LaserScan scan = made_scan(1);
  const LaserScan bare = made_scan(2);
  const Features features = made_features();
  const Truth truth = made_truth(scan.num_beams());
  writer->write({.scan = scan, .features = &features, .truth = &truth});
  writer->write({.scan = bare});
  writer->finish();
  const Reading reading = read_all(bytes_of(folder / "x.mcap"), "x.mcap");
  ASSERT_EQ(reading.scans.size(), 2U);
  ASSERT_TRUE(reading.features[0] && reading.truths[0]);
  EXPECT_EQ(reading.features[0]->legs[0].middle_m, features.legs[0].middle_m);
  EXPECT_EQ(reading.truths[0]->objects[0].label, "column");
  EXPECT_FALSE(reading.features[1] || reading.truths[1]);
}

}  // namespace
}  // namespace scanbed::hw
