// SPDX-License-Identifier: MIT
#include "core/interpret/piece_order.hpp"

#include <gtest/gtest.h>

#include "core/geometry/polar.hpp"

namespace scanbed {
namespace {

// A beam every degree, from straight ahead on.
LaserScan scan_of(int num_beams) {
  LaserScan scan;
  scan.geometry = {.num_beams = num_beams, .first_rad = 0.0, .step_rad = radians(1.0)};
  scan.range_m.assign(num_beams, 1.0);
  return scan;
}

// A piece from one beam to another of the turn; where the seam lies between them, with the beams of its
// larger part, as FullTurn gives them.
Line piece(int first, int last) {
  Line line{
      .beams = {first, last}, .left_m = polar(radians(first), 1.0), .right_m = polar(radians(last), 1.0)};
  if (first > last) line.beams = 360 - first > last + 1 ? BeamSpan{first, 359} : BeamSpan{0, last};
  return line;
}

void expect_between(const BeamSpan& beams, int first, int last) {
  EXPECT_EQ(beams.first, first);
  EXPECT_EQ(beams.last, last);
}

TEST(PieceOrderTest, LessThanATurnHasABeginningAndAnEnd) {
  const LaserScan scan = scan_of(181);
  const PieceOrder order(scan, 3);
  EXPECT_EQ(order.num_after(0), 2);
  EXPECT_EQ(order.num_after(2), 0);
  EXPECT_EQ(order.after(0, 2), 2);
  expect_between(order.between(piece(10, 20), piece(30, 40)), 21, 29);
  expect_between(order.between(piece(10, 20), piece(20, 40)), 21, 19);
}

TEST(PieceOrderTest, ATurnHasNeither) {
  const LaserScan scan = scan_of(360);
  const PieceOrder order(scan, 3);
  EXPECT_EQ(order.num_after(0), 2);
  EXPECT_EQ(order.num_after(2), 2);
  EXPECT_EQ(order.after(2, 1), 0);
  EXPECT_EQ(order.after(2, 2), 1);
  EXPECT_EQ(PieceOrder(scan, 1).num_after(0), 0);
}

TEST(PieceOrderTest, BeamsBetweenGoOnBehindTheSeam) {
  for (const int num_beams : {360, 361}) {
    const LaserScan scan = scan_of(num_beams);
    const PieceOrder order(scan, 2);
    expect_between(order.between(piece(10, 20), piece(30, 40)), 21, 29);
    expect_between(order.between(piece(10, 20), piece(20, 40)), 21, 19);
    expect_between(order.between(piece(300, 340), piece(5, 40)), 341, 364);
    expect_between(order.between(piece(300, 359), piece(5, 40)), 360, 364);
    expect_between(order.between(piece(300, 350), piece(0, 40)), 351, 359);
    expect_between(order.between(piece(300, 359), piece(0, 40)), 360, 359);
  }
}

TEST(PieceOrderTest, APieceAcrossTheSeamEndsWhereItEnds) {
  const LaserScan scan = scan_of(360);
  const PieceOrder order(scan, 2);
  expect_between(order.between(piece(300, 330), piece(350, 20)), 331,
                 349);  // of which beams 0 to 20 are given
  expect_between(order.between(piece(300, 330), piece(340, 10)), 331, 339);  // 340 to 359
  expect_between(order.between(piece(350, 20), piece(30, 40)), 21, 29);
  expect_between(order.between(piece(340, 10), piece(30, 40)), 11, 29);
  expect_between(order.between(piece(340, 10), piece(10, 40)), 11, 9);
}

}  // namespace
}  // namespace scanbed
