// SPDX-License-Identifier: MIT
#include "hw/recording/piece_reader.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace scanbed::hw
