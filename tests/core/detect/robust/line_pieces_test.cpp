// SPDX-License-Identifier: MIT
#include "core/detect/robust/line_pieces.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;
using testing::with_noise;

struct Split {
  Echoes echoes;
  std::vector<LinePiece> pieces;
};

Split split(const LaserScan& scan) {
  Split result;
  EchoReader().read(scan, {}, result.echoes);
  RayLineSums sums;
  sums.build(result.echoes);
  const SurfaceOptions options;
  LineSplitter splitter;
  splitter.begin(result.echoes, sums, options);
  splitter.split({0, result.echoes.size() - 1}, result.pieces);
  return result;
}

TEST(LineSplitterTest, AWallIsOnePiece) {
  IdealScene scene;
  scene.wall({3.0, -2.0}, {3.0, 2.0});
  const Split result = split(with_noise(scene.scan(), 0.005, 1));
  ASSERT_EQ(result.pieces.size(), 1u);
  // 14 for the line, and as much chi squared as there are points less two, give or take four sigma.
  const double expected = result.echoes.size() - 2;
  EXPECT_NEAR(result.pieces[0].cost, 14.0 + expected / (1.15 * 1.15), 4.0 * std::sqrt(2.0 * expected));
}

TEST(LineSplitterTest, ACornerSplitsWhereItIs) {
  IdealScene scene;
  scene.wall({3.0, -2.0}, {3.0, 1.0});
  scene.wall({3.0, 1.0}, {1.0, 1.0});
  const LaserScan scan = with_noise(scene.scan(), 0.005, 2);
  const Split result = split(scan);
  ASSERT_EQ(result.pieces.size(), 2u);
  const double corner_beam =
      (std::atan2(1.0, 3.0) - scan.geometry.first_rad) / scan.geometry.step_rad;  // as the wall meets it
  EXPECT_NEAR(result.echoes.beam[result.pieces[0].places.last], corner_beam, 2.0);
  EXPECT_EQ(result.pieces[1].places.first, result.pieces[0].places.last + 1);
}

TEST(LineSplitterTest, PiecesCoverTheSurfaceInOrder) {
  IdealScene scene;
  scene.cylinder({1.5, 0.0}, 0.5);
  const Split result = split(with_noise(scene.scan(), 0.005, 3));
  ASSERT_GE(result.pieces.size(), 3u);
  int next = 0;
  for (const LinePiece& piece : result.pieces) {
    EXPECT_EQ(piece.places.first, next);
    next = piece.places.last + 1;
  }
  EXPECT_EQ(next, result.echoes.size());
}

TEST(LineSplitterTest, WhatNoLineExplainsIsGivenUp) {
  LaserScan scan;
  for (int i = 0; i < 3; ++i) scan.range_m.push_back(i == 1 ? 2.4 : 2.0);
  const Split result = split(scan);
  double cost = 0.0;
  for (const LinePiece& piece : result.pieces) cost += piece.cost;
  EXPECT_LE(cost, 3 * SurfaceOptions{}.clutter_price);
}

}  // namespace
}  // namespace scanbed
