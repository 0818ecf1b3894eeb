// SPDX-License-Identifier: MIT
#include "core/detect/robust/line_pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/angles.hpp"
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
  const Stretch all{0, result.echoes.size() - 1};
  splitter.add(all);
  splitter.split();
  splitter.append_pieces(all, result.pieces);
  splitter.settle_cuts(result.pieces);
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

// A door set back in the far wall moves the first cut; it shall end at the corner of the room all the same.
TEST(LineSplitterTest, ANicheFartherOnMovesNoCorner) {
  for (const double niche_m : {-0.6, -0.3, 0.0, 0.3, 0.6}) {
    IdealScene scene;
    scene.wall({-1.0, -4.0}, {2.0, -4.0});
    scene.wall({2.0, -4.0}, {2.0, niche_m - 0.5});
    scene.wall({2.0, niche_m - 0.5}, {2.12, niche_m - 0.5});
    scene.wall({2.12, niche_m - 0.5}, {2.12, niche_m + 0.5});
    scene.wall({2.12, niche_m + 0.5}, {2.0, niche_m + 0.5});
    scene.wall({2.0, niche_m + 0.5}, {2.0, 4.0});
    scene.wall({2.0, 4.0}, {-1.0, 4.0});
    const Split result = split(scene.scan());
    const double corner_beam = degrees(kPi / 2 - std::atan2(4.0, 2.0)) / 0.5;
    ASSERT_GE(result.pieces.size(), 4u);
    EXPECT_EQ(result.echoes.beam[result.pieces.front().places.last], std::floor(corner_beam)) << niche_m;
    EXPECT_EQ(result.echoes.beam[result.pieces.back().places.first], 360 - std::floor(corner_beam))
        << niche_m;
  }
}

// Rooms in noise of 20 mm whose pieces went together otherwise when they were read from the last beam, as
// long as a piece went with the first neighbour that it could go with.
TEST(LineSplitterTest, PiecesMergeAlikeFromEitherSide) {
  for (const unsigned seed : {349u, 440u, 603u, 760u, 817u, 924u}) {
    IdealScene scene({.num_beams = 91, .step_rad = kPi / 90});
    const double shift_m = 0.002 * seed;
    scene.wall({1.0, -2.0 - shift_m}, {4.0, -2.0});
    scene.wall({4.0, -2.0}, {4.0 - shift_m, 0.3});
    scene.wall({4.0 - shift_m, 0.3}, {3.0, 2.0});
    scene.wall({3.0, 2.0}, {1.0, 1.5});
    LaserScan scan = with_noise(scene.scan(), 0.02, seed);
    const Split plain = split(scan);
    std::reverse(scan.range_m.begin(), scan.range_m.end());
    const Split mirrored = split(scan);
    const int last = plain.echoes.size() - 1;
    const std::size_t num_pieces = plain.pieces.size();
    ASSERT_EQ(mirrored.pieces.size(), num_pieces) << seed;
    for (std::size_t i = 0; i < num_pieces; ++i) {
      EXPECT_EQ(mirrored.pieces[num_pieces - 1 - i].places.first, last - plain.pieces[i].places.last) << seed;
    }
  }
}

// Chi squared that two lines leave, by trying every cut.
double least_chi2_of_two(const RayLineSums& sums, Stretch places) {
  double least = sums.fit(places).chi2;
  for (int cut = places.first + 1; cut + 2 < places.last; ++cut) {
    least = std::min(least, sums.fit({places.first, cut}).chi2 + sums.fit({cut + 1, places.last}).chi2);
  }
  return least;
}

// Corners of all angles, anywhere on walls of few and of many beams.
TEST(LineSplitterTest, ACornerIsCutWhereTheTwoLinesFitBest) {
  for (int num_beams : {181, 361, 721, 1441}) {
    ScanGeometry geometry;
    geometry.num_beams = num_beams;
    geometry.step_rad = kPi / (num_beams - 1);
    for (unsigned seed = 0; seed < 40; ++seed) {
      const double corner_y_m = -0.9 + 0.045 * seed;
      IdealScene scene(geometry);
      scene.wall({3.0, -2.0}, {2.0 + 0.01 * seed, corner_y_m});
      scene.wall({2.0 + 0.01 * seed, corner_y_m}, {3.0, 2.0});
      const Split result = split(with_noise(scene.scan(), 0.004, seed));
      ASSERT_EQ(result.pieces.size(), 2u) << num_beams << " " << seed;
      RayLineSums sums;
      sums.build(result.echoes);
      const double least = least_chi2_of_two(sums, {0, result.echoes.size() - 1});
      // Among many beams a neighbour of the best cut may be as good but for the noise: by less than any
      // price.
      EXPECT_NEAR(result.pieces[0].chi2 + result.pieces[1].chi2, least, num_beams <= 361 ? 1e-3 : 0.5);
    }
  }
}

TEST(LineSplitterTest, SurfacesAreSplitAsEachWouldBeAlone) {
  IdealScene scene;
  scene.wall({3.0, -2.0}, {3.0, 1.0});
  scene.wall({3.0, 1.0}, {1.0, 1.0});
  scene.cylinder({1.5, -1.0}, 0.4);
  Echoes echoes;
  EchoReader().read(with_noise(scene.scan(), 0.005, 2), {}, echoes);
  RayLineSums sums;
  sums.build(echoes);
  const SurfaceOptions options;
  const int third = echoes.size() / 3;
  const Stretch surfaces[] = {{0, third}, {third + 1, 2 * third}, {2 * third + 1, echoes.size() - 1}};
  LineSplitter together;
  together.begin(echoes, sums, options);
  for (const Stretch& surface : surfaces) together.add(surface);
  together.split();
  for (const Stretch& surface : surfaces) {
    LineSplitter alone;
    alone.begin(echoes, sums, options);
    alone.add(surface);
    alone.split();
    std::vector<LinePiece> expected;
    std::vector<LinePiece> pieces;
    alone.append_pieces(surface, expected);
    together.append_pieces(surface, pieces);
    ASSERT_EQ(pieces.size(), expected.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      EXPECT_EQ(pieces[i].places.last, expected[i].places.last);
      EXPECT_EQ(pieces[i].cost, expected[i].cost);
    }
  }
}

TEST(LineSplitterTest, NoNeighboursAreLeftThatOneLineWouldExplainAtLessCost) {
  IdealScene scene;
  scene.cylinder({1.5, 0.0}, 0.5);
  scene.wall({2.5, -2.0}, {2.5, 2.0});
  const SurfaceOptions options;
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Split result = split(with_noise(scene.scan(), 0.02, seed));
    RayLineSums sums;
    sums.build(result.echoes);
    for (std::size_t i = 0; i + 1 < result.pieces.size(); ++i) {
      const Stretch both{result.pieces[i].places.first, result.pieces[i + 1].places.last};
      const double as_one =
          std::min(options.line_price + sums.fit(both).chi2, options.clutter_price * both.size());
      EXPECT_GT(as_one, result.pieces[i].cost + result.pieces[i + 1].cost - 1e-6);
    }
  }
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
