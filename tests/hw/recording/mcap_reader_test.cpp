// SPDX-License-Identifier: MIT
#include "hw/recording/mcap_reader.hpp"

#include <gtest/gtest.h>

#include "hw/recording/byte_sink.hpp"
#include "hw/recording/mcap_message.hpp"
#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

std::string record(McapOp op, const std::string& content) {
  std::string out;
  append_mcap_record(out, op, content);
  return out;
}

std::string schema(std::uint16_t id, std::string_view name) {
  std::string content;
  append_number(content, id);
  append_mcap_text(content, name);
  append_mcap_text(content, "jsonschema");
  append_mcap_text(content, "{}");
  return record(McapOp::kSchema, content);
}

std::string channel(std::uint16_t id, std::uint16_t schema_id, std::string_view topic,
                    std::string_view encoding = "json") {
  std::string content;
  append_number(content, id);
  append_number(content, schema_id);
  append_mcap_text(content, topic);
  append_mcap_text(content, encoding);
  append_mcap_map(content, {});
  return record(McapOp::kChannel, content);
}

std::string message(std::uint16_t channel_id, const std::string& json) {
  std::string content;
  append_number(content, channel_id);
  append_number(content, std::uint32_t{0});
  append_number(content, std::uint64_t{5});
  append_number(content, std::uint64_t{5});
  return record(McapOp::kMessage, content + json);
}

std::string chunk(const std::string& records, std::uint64_t num_bytes, std::uint32_t crc) {
  std::string content(16, '\0');
  append_number(content, num_bytes);
  append_number(content, crc);
  append_mcap_text(content, "");
  append_number(content, static_cast<std::uint64_t>(records.size()));
  return record(McapOp::kChunk, content + records);
}

std::string file(const std::string& records) {
  return std::string(kMcapMagic) + records + record(McapOp::kDataEnd, std::string(4, '\0')) +
         record(McapOp::kFooter, std::string(20, '\0')) + std::string(kMcapMagic);
}

std::string scan_records(int number) {
  return schema(1, "foxglove.LaserScan") + channel(3, 1, "/scan") +
         message(3, encode_mcap_scan(made_scan(number)));
}

TEST(McapReaderTest, ReadsMessagesInAndOutOfChunks) {
  const std::string inside = scan_records(1);
  const std::string second = message(3, encode_mcap_scan(made_scan(2)));
  const Reading reading =
      read_all(file(chunk(inside, inside.size(), mcap_crc(0, inside)) + second), "x.mcap");
  EXPECT_EQ(reading.error, "");
  ASSERT_EQ(reading.scans.size(), 2U);
  EXPECT_EQ(reading.scans[1].range_m[0], made_scan(2).range_m[0]);
}

TEST(McapReaderTest, SkipsRecordsAndChannelsItDoesNotKnow) {
  const std::string other = schema(2, "a.Thing") + channel(4, 2, "/thing") + message(4, "not json");
  const std::string unknown = record(McapOp{0x85}, "private") + record(McapOp{0x40}, "reserved");
  const Reading reading = read_all(file(other + unknown + scan_records(1)), "x.mcap");
  EXPECT_EQ(reading.error, "");
  EXPECT_EQ(reading.scans.size(), 1U);
  EXPECT_EQ(reading.counts.num_other_lines, 1);
  EXPECT_TRUE(reading.reports.empty());
}

TEST(McapReaderTest, SaysWhichScansItDoesNotRead) {
  const std::string ros =
      file(schema(1, "sensor_msgs/LaserScan") + channel(1, 1, "/scan", "ros1") + message(1, "x"));
  EXPECT_NE(read_all(ros, "x.mcap")
                .error.find("holds no scan; not read: sensor_msgs/LaserScan in ros1 "
                            "(read: foxglove.LaserScan in json)"),
            std::string::npos)
      << read_all(ros, "x.mcap").error;
}

TEST(McapReaderTest, ADamagedChunkIsReportedAndSkipped) {
  const std::string inside = scan_records(1);
  const Reading wrong_crc = read_all(file(chunk(inside, inside.size(), 1) + scan_records(2)), "x.mcap");
  EXPECT_EQ(wrong_crc.scans.size(), 1U);
  ASSERT_EQ(wrong_crc.reports.size(), 1U);
  EXPECT_NE(wrong_crc.reports[0].find("checksum"), std::string::npos);
  const Reading wrong_size = read_all(file(chunk(inside, ~std::uint64_t{0}, 0) + scan_records(2)), "x.mcap");
  EXPECT_EQ(wrong_size.scans.size(), 1U);
  EXPECT_EQ(wrong_size.reports.size(), 1U);
}

TEST(McapReaderTest, AMessageOfNoChannelIsReported) {
  const Reading reading = read_all(file(scan_records(1) + message(9, "{}") + message(3, "{}")), "x.mcap");
  EXPECT_EQ(reading.scans.size(), 1U);
  EXPECT_EQ(reading.counts.num_damaged_lines, 2);
}

TEST(McapReaderTest, ChecksTheChecksumOverAllData) {
  std::string bytes = recorded("x.mcap", made_scans(2));
  // The library's name in the header, which no other checksum covers.
  const std::size_t at = bytes.find("scanbed");
  bytes[at] = 'S';
  const Reading reading = read_all(bytes, "x.mcap");
  EXPECT_EQ(reading.scans.size(), 2U);
  EXPECT_EQ(reading.error, "x.mcap: is damaged: the checksum over all its data does not fit");
}

TEST(McapReaderTest, ReportsOnceWhatStandsBehindItsEnd) {
  const std::string one = recorded("x.mcap", made_scans(3));
  EXPECT_TRUE(read_all(one, "x.mcap").reports.empty());
  const Reading reading = read_all(one + one, "x.mcap");
  EXPECT_EQ(reading.error, "");
  EXPECT_EQ(reading.scans.size(), 3U);
  EXPECT_EQ(
      reading.reports,
      std::vector<std::string>{"x.mcap: record at byte " + std::to_string(one.size()) +
                               " skipped: stands behind the end of the recording, as all that follows does"});
}

TEST(McapReaderTest, SaysThatItsCompressionIsDamagedUpToItsLastByte) {
  const TemporaryFolder folder;
  const auto sink = pack_gzip(std::make_unique<FileSink>(folder / "x.gz"));
  sink->append(recorded("x.mcap", made_scans(3)));
  sink->finish();
  std::string packed = bytes_of(folder / "x.gz");
  EXPECT_EQ(read_all(packed, "x.mcap").error, "");
  packed[packed.size() - 8] ^= 1;  // its checksum
  EXPECT_EQ(read_all(packed, "x.mcap").error, "x.mcap: compressed data is damaged after 3 scans");
}

TEST(McapReaderTest, AbsurdLengthsAreRefusedAtOnce) {
  std::string bytes = std::string(kMcapMagic) + "\x06" + std::string(8, '\xff');
  EXPECT_EQ(read_all(bytes, "x.mcap").error,
            "x.mcap: record at byte 8: claims 18446744073709551615 bytes, more than 268439552");
  bytes[8] = '\0';
  EXPECT_EQ(read_all(bytes, "x.mcap").error, "x.mcap: record at byte 8: is of kind 0, which there is not");
}

TEST(McapReaderTest, RefusesOtherFiles) {
  EXPECT_EQ(read_all("\x89MCAP1\r\n", "x.mcap").error,
            "x.mcap: is no MCAP file of version 0: it begins otherwise");
}

/// Independent writers' files.
TEST(McapReaderTest, ReadsTheChunksOfOtherWriters) {
  const std::filesystem::path path = SCANBED_SOURCE_DIR "/../shared/facts/samples/sample.mcap";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no sample at " << path;
  const Reading reading = read_all(bytes_of(path), "sample.mcap");
  EXPECT_EQ(reading.error, "");
  EXPECT_GT(reading.scans.size(), 0U);
  EXPECT_TRUE(reading.reports.empty()) << reading.reports.front();
}

}  // namespace
}  // namespace scanbed::hw
