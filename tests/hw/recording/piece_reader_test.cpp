// SPDX-License-Identifier: MIT
#include "hw/recording/piece_reader.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/hw/recording/late_parts.hpp"

namespace scanbed::hw {
namespace {

TEST(PieceReaderTest, GivesPiecesInOrderAndCountsBytes) {
  PieceReader pieces(from_memory("abcdef"));
  std::string piece = "old";
  EXPECT_TRUE(pieces.read(piece, 2));
  EXPECT_EQ(piece, "ab");
  EXPECT_TRUE(pieces.read(piece, 0));
  EXPECT_EQ(piece, "");
  EXPECT_TRUE(pieces.read(piece, 4));
  EXPECT_EQ(piece, "cdef");
  EXPECT_EQ(pieces.offset(), 6U);
}

// An announcement of 16 EiB must not be believed.
TEST(PieceReaderTest, AtTheEndGivesWhatThereIs) {
  PieceReader pieces(from_memory("abc"));
  std::string piece;
  EXPECT_FALSE(pieces.read(piece, ~std::uint64_t{0}));
  EXPECT_EQ(piece, "abc");
  EXPECT_LT(piece.capacity(), std::size_t{1} << 20);
  EXPECT_FALSE(pieces.read(piece, 1));
  EXPECT_EQ(piece, "");
}

TEST(PieceReaderTest, PiecesMayBeLong) {
  const std::string text(3'000'000, 'x');
  PieceReader pieces(from_memory(text + "y"));
  std::string piece;
  EXPECT_TRUE(pieces.read(piece, text.size()));
  EXPECT_EQ(piece, text);
}

TEST(PieceReaderTest, TellsWhatHasArrivedWithoutTakingIt) {
  std::size_t num_arrived = 0;
  PieceReader pieces(std::make_unique<LateParts>(std::vector<std::string>{"abc", "defg"}, num_arrived));
  EXPECT_FALSE(pieces.has(1, 0.0));
  std::string piece;
  EXPECT_TRUE(pieces.read(piece, 1));
  EXPECT_TRUE(pieces.has(2, 0.0));
  EXPECT_EQ(pieces.ahead(), "bc");
  EXPECT_FALSE(pieces.has(4, 0.0));
  EXPECT_EQ(num_arrived, 1U);
  EXPECT_EQ(pieces.offset(), 1U);
  EXPECT_TRUE(pieces.has(4, std::numeric_limits<double>::infinity()));
  EXPECT_EQ(num_arrived, 1U) << "who may wait for ever need not look ahead";
  EXPECT_TRUE(pieces.read(piece, 4));
  EXPECT_EQ(piece, "bcde");
  EXPECT_EQ(num_arrived, 2U);
  EXPECT_FALSE(pieces.has(3, 0.0)) << "the end has not come";
  EXPECT_FALSE(pieces.read(piece, 3));
  EXPECT_EQ(piece, "fg");
  EXPECT_TRUE(pieces.has(3, 0.0)) << "nothing more will come";
  EXPECT_EQ(pieces.offset(), 7U);
}

}  // namespace
}  // namespace scanbed::hw
