// SPDX-License-Identifier: MIT
#include "hw/recording/compression.hpp"

#include <gtest/gtest.h>
#include <zstd.h>

#include "core/errors/input_error.hpp"
#include "tests/support/bzip2.hpp"

namespace scanbed::hw {
namespace {

using tests::bzip2;

std::string zstd(const std::string& bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 3));
  return packed;
}

std::string pack(const std::string& bytes, Packing packing) {
  if (packing == Packing::kBzip2) return bzip2(bytes);
  if (packing == Packing::kLz4) return pack_lz4(bytes);
  return packing == Packing::kZstd ? zstd(bytes) : bytes;
}

std::string text_of(std::size_t size) {
  std::string text;
  for (std::size_t i = 0; text.size() < size; ++i) text += std::to_string(i * i * 7919);
  text.resize(size);
  return text;
}

class PackingTest : public testing::TestWithParam<Packing> {};

TEST_P(PackingTest, UnpacksWhatWasPacked) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{1000}, std::size_t{3'000'000}}) {
    const std::string text = text_of(size);
    EXPECT_EQ(unpack_chunk(pack(text, GetParam()), GetParam(), size), text) << size;
  }
}

TEST_P(PackingTest, RefusesAnotherSizeThanClaimed) {
  const std::string packed = pack(text_of(1000), GetParam());
  for (const std::uint64_t size : {0ULL, 1ULL, 999ULL, 1001ULL, 1ULL << 32, ~0ULL}) {
    EXPECT_THROW(unpack_chunk(packed, GetParam(), size), InputError) << size;
  }
}

TEST_P(PackingTest, RefusesWhatIsCutOffOrFollowedByMore) {
  const std::string packed = pack(text_of(1000), GetParam());
  for (std::size_t size = 0; size < packed.size(); ++size) {
    EXPECT_THROW(unpack_chunk(packed.substr(0, size), GetParam(), 1000), InputError) << size;
  }
  EXPECT_THROW(unpack_chunk(packed + "x", GetParam(), 1000), InputError);
}

INSTANTIATE_TEST_SUITE_P(Kinds, PackingTest,
                         testing::Values(Packing::kNone, Packing::kBzip2, Packing::kLz4, Packing::kZstd));

// A bomb is stopped at the size it claims, long before its own.
TEST(CompressionTest, StopsABombAtWhatItClaims) {
  const std::string zeros(std::size_t{100} << 20, '\0');
  EXPECT_THROW(unpack_chunk(bzip2(zeros), Packing::kBzip2, 1000), InputError);
  EXPECT_THROW(unpack_chunk(pack_lz4(zeros), Packing::kLz4, 1000), InputError);
  EXPECT_THROW(unpack_chunk(zstd(zeros), Packing::kZstd, 1000), InputError);
}

// rosbag takes frames that begin so: version 1, independent blocks, checksum of the content, block size 4
// to 7.
TEST(CompressionTest, Lz4FramesAreOfTheKindThatRosbagTakes) {
  for (const std::size_t size : {std::size_t{10}, std::size_t{100'000}, std::size_t{3'000'000}}) {
    const std::string packed = pack_lz4(text_of(size));
    EXPECT_EQ(packed.substr(0, 5), "\x04\x22\x4d\x18\x64") << size;
    EXPECT_GE(packed[5], 0x40) << size;
    EXPECT_LE(packed[5], 0x70) << size;
  }
}

TEST(CompressionTest, KnowsTheNames) {
  EXPECT_EQ(packing_of_name(""), Packing::kNone);
  EXPECT_EQ(packing_of_name("none"), Packing::kNone);
  EXPECT_EQ(packing_of_name("bz2"), Packing::kBzip2);
  EXPECT_EQ(packing_of_name("lz4"), Packing::kLz4);
  EXPECT_EQ(packing_of_name("zstd"), Packing::kZstd);
  EXPECT_FALSE(packing_of_name("rar").has_value());
}

}  // namespace
}  // namespace scanbed::hw
