// SPDX-License-Identifier: MIT
#include "hw/recording/bag_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hw/recording/bag_record.hpp"
#include "hw/recording/ros_messages.hpp"
#include "tests/hw/recording/made_recording.hpp"
#include "tests/support/bzip2.hpp"

namespace scanbed::hw {
namespace {

using tests::bzip2;

std::string bag_header(std::uint64_t index_position) {
  std::string out(kBagMagic);
  append_bag_record(out,
                    BagHeader(BagOp::kBagHeader)
                        .field("index_pos", index_position)
                        .field("conn_count", std::uint32_t{0})
                        .field("chunk_count", std::uint32_t{0}),
                    "");
  return out;
}

std::string connection(std::uint32_t id, std::string_view topic, std::string_view md5 = kLaserScanType.md5) {
  std::string out;
  const BagHeader data = BagHeader().field("type", kLaserScanType.name).field("md5sum", md5);
  append_bag_record(out, BagHeader(BagOp::kConnection).field("conn", id).field("topic", topic), data.bytes());
  return out;
}

std::string message(std::uint32_t id, const std::string& data, std::uint64_t time = 0) {
  std::string out;
  append_bag_record(out, BagHeader(BagOp::kMessage).field("conn", id).field("time", time), data);
  return out;
}

std::string chunk(std::string_view packing, std::size_t num_bytes, std::string_view packed) {
  std::string out;
  append_bag_record(out,
                    BagHeader(BagOp::kChunk)
                        .field("compression", packing)
                        .field("size", static_cast<std::uint32_t>(num_bytes)),
                    packed);
  return out;
}

std::string plain_chunk(const std::string& records) {
  return chunk("none", records.size(), records);
}

std::string records_of(int number) {
  return connection(0, "/scan") + message(0, encode_laser_scan(made_scan(number), 0));
}

TEST(BagReaderTest, AScanWithoutTimeHasThatOfItsRecord) {
  constexpr std::uint64_t kOneAndAHalf_s = 1 + (std::uint64_t{500'000'000} << 32U);
  const std::string records = connection(0, "/scan") +
                              message(0, encode_laser_scan(made_scan(0), 0), kOneAndAHalf_s) +
                              message(0, encode_laser_scan(made_scan(8), 1), kOneAndAHalf_s);
  const Reading reading = read_all(bag_header(1) + plain_chunk(records), "x.bag");
  ASSERT_EQ(reading.scans.size(), 2U);
  EXPECT_EQ(reading.scans[0].time_s, 1.5);
  EXPECT_EQ(reading.scans[1].time_s, 2.0);
}

TEST(BagReaderTest, ReadsPlainAndBzip2Chunks) {
  const std::string records = records_of(3);
  for (const std::string& bytes : {plain_chunk(records), chunk("bz2", records.size(), bzip2(records))}) {
    const Reading reading = read_all(bag_header(1) + bytes, "x.bag");
    EXPECT_EQ(reading.error, "");
    ASSERT_EQ(reading.scans.size(), 1U);
    EXPECT_TRUE(same_ranges(reading.scans[0], made_scan(3)));
  }
}

TEST(BagReaderTest, TopicsAreSources) {
  const std::string message0 = message(0, encode_laser_scan(made_scan(0), 0));
  const std::string message1 = message(1, encode_laser_scan(made_scan(1), 0));
  const std::string bytes =
      bag_header(1) + plain_chunk(connection(0, "/scan") + connection(1, "/rear/scan") + message0 + message1);
  const Reading both = read_all(bytes, "x.bag");
  ASSERT_EQ(both.scans.size(), 2U);
  EXPECT_EQ(both.scans[0].source, "");
  EXPECT_EQ(both.scans[1].source, "rear/scan");
  const Reading rear = read_all(bytes, "x.bag", {.only = "/rear/scan"});
  ASSERT_EQ(rear.scans.size(), 1U);
  EXPECT_EQ(rear.counts.num_other_lines, 1);
}

TEST(BagReaderTest, TheWholeMessagesOfATornPlainChunkAreRead) {
  const std::string second = message(0, encode_laser_scan(made_scan(2), 0));
  const std::string bytes = bag_header(0) + plain_chunk(records_of(1) + second);
  const Reading reading = read_all(bytes.substr(0, bytes.size() - 1), "x.bag");
  EXPECT_EQ(reading.scans.size(), 1U);
  EXPECT_EQ(reading.error,
            "x.bag: is not finished: it ends after 1 scans without its index (cut off, or its recorder was "
            "killed)");
}

// As rosbag leaves it when it is killed: the chunk that it was writing has no length yet.
TEST(BagReaderTest, TheWholeMessagesOfAnUnfinishedChunkAreRead) {
  const std::string start = bag_header(0) + plain_chunk(records_of(1));
  const std::string records =
      records_of(2) + message(0, "short") + message(0, encode_laser_scan(made_scan(3), 0));
  const std::string plain = start + chunk("none", 0, "") + records;
  const Reading whole = read_all(plain, "x.bag");
  ASSERT_EQ(whole.scans.size(), 3U);
  EXPECT_TRUE(same_ranges(whole.scans[2], made_scan(3)));
  EXPECT_EQ(whole.counts.num_damaged_lines, 1);
  EXPECT_NE(whole.error.find("is not finished: it ends after 3 scans"), std::string::npos) << whole.error;
  const Reading torn = read_all(plain.substr(0, plain.size() - 1), "x.bag");
  EXPECT_EQ(torn.scans.size(), 2U);
  EXPECT_NE(torn.error.find("is not finished: it ends after 2 scans"), std::string::npos) << torn.error;
  const Reading packed = read_all(start + chunk("bz2", 0, "") + bzip2(records).substr(0, 100), "x.bag");
  EXPECT_EQ(packed.scans.size(), 1U);
  EXPECT_NE(packed.error.find("is not finished: it ends after 1 scans"), std::string::npos) << packed.error;
}

TEST(BagReaderTest, AMessageOutsideOfAChunkIsNone) {
  const Reading reading = read_all(bag_header(1) + plain_chunk(records_of(1)) + records_of(2), "x.bag");
  EXPECT_EQ(reading.scans.size(), 1U);
  EXPECT_NE(reading.error.find("is of an unknown kind"), std::string::npos) << reading.error;
}

TEST(BagReaderTest, AMessageThatIsNoScanIsReportedAndSkipped) {
  const std::string records = records_of(1) + message(0, "short") + message(9, "unknown connection") +
                              message(0, encode_laser_scan(made_scan(2), 0));
  const Reading reading = read_all(bag_header(1) + plain_chunk(records), "x.bag");
  EXPECT_EQ(reading.error, "");
  EXPECT_EQ(reading.scans.size(), 2U);
  EXPECT_EQ(reading.reports.size(), 2U);
  EXPECT_EQ(reading.counts.num_damaged_lines, 2);
}

// Never guess a layout: another sum is another message.
TEST(BagReaderTest, AnotherLayoutOfLaserScanIsNotRead) {
  const std::string records = connection(0, "/scan", "0000") + message(0, encode_laser_scan(made_scan(1), 0));
  EXPECT_EQ(read_all(bag_header(1) + plain_chunk(records), "x.bag").error,
            "x.bag: holds no scan; not read: sensor_msgs/LaserScan with another sum (0 damaged, 1 other "
            "lines or records)");
}

TEST(BagReaderTest, AbsurdLengthsAreRefusedAtOnce) {
  const std::string huge = "\xff\xff\xff\xff";
  const std::string start = bag_header(1);
  EXPECT_EQ(read_all(start + huge, "x.bag").error, "x.bag: record at byte " + std::to_string(start.size()) +
                                                       ": claims 4294967295 bytes, more than 1048576");
  std::string header;
  append_bag_record(header, BagHeader(BagOp::kChunk), "");
  header.replace(header.size() - 4, 4, huge);
  EXPECT_NE(read_all(start + header, "x.bag").error.find("claims 4294967295 bytes"), std::string::npos);
}

TEST(BagReaderTest, BombsAreRefused) {
  const std::string records = records_of(1);
  const std::string bomb = bzip2(std::string(std::size_t{64} << 20, '\0'));
  const Reading lies = read_all(bag_header(1) + chunk("bz2", 100, bomb) + plain_chunk(records), "x.bag");
  EXPECT_EQ(lies.scans.size(), 1U);
  ASSERT_EQ(lies.reports.size(), 1U);
  EXPECT_NE(lies.reports[0].find("unpacks to more than the 100 bytes it claims"), std::string::npos);
  const Reading honest =
      read_all(bag_header(1) + chunk("bz2", 0xffffffffU, bomb) + plain_chunk(records), "x.bag");
  EXPECT_EQ(honest.scans.size(), 1U);
  EXPECT_NE(honest.reports.at(0).find("claims to unpack to 4294967295 bytes"), std::string::npos);
}

TEST(BagReaderTest, RefusesOtherFilesAndEncryptedBags) {
  EXPECT_EQ(read_all("#ROSBAG V1.2\n", "x.bag").error,
            "x.bag: is no ROS bag of version 2.0: it begins otherwise");
  std::string encrypted(kBagMagic);
  append_bag_record(encrypted,
                    BagHeader(BagOp::kBagHeader)
                        .field("index_pos", std::uint64_t{1})
                        .field("conn_count", std::uint32_t{0})
                        .field("chunk_count", std::uint32_t{0})
                        .field("encryptor", std::string_view("aes")),
                    "");
  EXPECT_NE(read_all(encrypted, "x.bag").error.find("encrypted"), std::string::npos);
}

// As its README says: 83 scans of 768 beams, 0.352 degrees apart (a Hokuyo: 1024 steps a turn).
TEST(BagReaderTest, ReadsARecordedBag) {
  const std::filesystem::path path = SCANBED_SOURCE_DIR "/../shared/data/legs_pos2.bag";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no recording at " << path;
  Reading reading;
  read_to_end(*open_recording(path, {}, {}), reading);
  ASSERT_EQ(reading.scans.size(), 83U);
  double time_s = 0.0;
  for (const LaserScan& scan : reading.scans) {
    EXPECT_EQ(scan.num_beams(), 768);
    EXPECT_NEAR(degrees(scan.geometry.step_rad), 0.352, 0.001);
    EXPECT_GT(scan.time_s, time_s);
    time_s = scan.time_s;
  }
}

// Its CARMEN sibling was made from the same recording, resampled to half degrees.
TEST(BagReaderTest, AgreesWithTheCarmenLogOfTheSameRecording) {
  const std::filesystem::path folder = SCANBED_SOURCE_DIR "/../shared/data";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no recordings in " << folder;
  Reading bag;
  Reading log;
  read_to_end(*open_recording(folder / "legs_pos2.bag", {}, {}), bag);
  read_to_end(*open_recording(folder / "legs_pos2.log", {}, {}), log);
  ASSERT_EQ(bag.scans.size(), log.scans.size());
  int num_compared = 0;
  int num_alike = 0;
  for (std::size_t i = 0; i < bag.scans.size(); ++i) {
    const ScanGeometry& geometry = bag.scans[i].geometry;
    for (int beam = 0; beam < log.scans[i].num_beams(); ++beam) {
      if (!log.scans[i].has_echo(beam)) continue;
      const double place = (log.scans[i].geometry.bearing_rad(beam) - geometry.first_rad) / geometry.step_rad;
      const int nearest = static_cast<int>(std::lround(place));
      ++num_compared;
      const auto range_m = [nearest](const LaserScan& scan) {
        return scan.range_m.at(static_cast<std::size_t>(nearest));
      };
      num_alike +=
          std::abs(range_m(bag.scans[i]) - log.scans[i].range_m[static_cast<std::size_t>(beam)]) < 0.05;
    }
  }
  EXPECT_GT(num_compared, 83 * 100);
  // All but those beside an edge, where the neighbouring beam was another one.
  EXPECT_GT(num_alike, num_compared * 9 / 10);
}

}  // namespace
}  // namespace scanbed::hw
