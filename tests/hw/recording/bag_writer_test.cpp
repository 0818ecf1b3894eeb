// SPDX-License-Identifier: MIT
#include "hw/recording/bag_writer.hpp"

#include <gtest/gtest.h>

#include "hw/recording/bag_reader.hpp"
#include "hw/recording/little_endian.hpp"
#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

TEST(BagWriterTest, TheFirstChunkStandsWhereRosbagPutsIt) {
  const std::string bytes = recorded("x.bag", made_scans(2));
  EXPECT_TRUE(bytes.starts_with(kBagMagic));
  // Magic, two lengths, and 4096 bytes of header and padding.
  EXPECT_EQ(ByteCursor(std::string_view(bytes).substr(13)).number<std::uint32_t>(), 69U);
  EXPECT_NE(bytes.substr(4117, 100).find("op=\x05"), std::string::npos);
}

TEST(BagWriterTest, CannotWriteToAPipe) {
  EXPECT_THROW(write_bag(std::make_unique<FileSink>("/dev/null")), InputError);
}

TEST(BagWriterTest, RefusesATimeThatRosCannotHold) {
  const TemporaryFolder folder;
  const auto writer = create_recording(folder / "x.bag", {});
  LaserScan scan = made_scan(1);
  scan.time_s = -1.0;
  EXPECT_THROW(writer->write({.scan = scan}), InputError);
}

TEST(BagWriterTest, EachChunkIsReadableWithoutTheOthers) {
  std::string bytes = recorded("x.bag", made_scans(10));
  bytes[4117 + 1000] ^= 0x10;  // in the first of three chunks: four scans
  const Reading reading = read_all(bytes, "x.bag");
  ASSERT_EQ(reading.scans.size(), 6U) << reading.error;
  EXPECT_EQ(reading.scans[0].range_m[0], made_scan(4).range_m[0]);
}

// As after kill -9: the file ends where the last chunk ended.
TEST(BagWriterTest, ChunksOfEachSecondAreReadableBeforeTheEnd) {
  const TemporaryFolder folder;
  const auto writer = create_recording(folder / "x.bag", {});
  for (const LaserScan& scan : made_scans(10)) writer->write({.scan = scan});
  EXPECT_FALSE(std::filesystem::exists(folder / "x.bag"));
  const Reading reading = read_all(bytes_of(folder / "x.bag.part"), "x.bag.part");
  EXPECT_EQ(reading.scans.size(), 8U);  // four a second, the third second is open
  EXPECT_NE(reading.error.find("is not finished"), std::string::npos);
  writer->finish();
  EXPECT_EQ(read_all(bytes_of(folder / "x.bag"), "x.bag").scans.size(), 10U);
  EXPECT_FALSE(std::filesystem::exists(folder / "x.bag.part"));
}

}  // namespace
}  // namespace scanbed::hw
