// SPDX-License-Identifier: MIT
#include "core/score/wall_pieces.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;

std::vector<WallPiece> pieces_of(const IdealScene& scene) {
  return visible_wall_pieces(scene.truth(), scene.scan());
}

TEST(WallPiecesTest, AWallInPlainViewIsOnePieceFromEndToEnd) {
  IdealScene scene;
  scene.wall({2.0, -1.0}, {2.0, 1.0});
  const auto pieces = pieces_of(scene);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_NEAR(pieces[0].length_m(), 2.0,
              2 * 2.0 * kPi / 360 * 1.25);  // a beam spacing at each end, seen aslant
  EXPECT_TRUE(pieces[0].is_resolvable());
}

TEST(WallPiecesTest, AColumnInFrontMakesTwoPieces) {
  IdealScene scene;
  scene.wall({4.0, -2.0}, {4.0, 2.0});
  scene.cylinder({2.0, 0.0}, 0.25);
  EXPECT_EQ(pieces_of(scene).size(), 2u);
}

TEST(WallPiecesTest, AThinPostInFrontDoesNot) {
  IdealScene scene;
  scene.wall({4.0, -2.0}, {4.0, 2.0});
  scene.cylinder({2.0, 0.0}, 0.02);  // 1.1 degrees wide: two or three beams
  EXPECT_EQ(pieces_of(scene).size(), 1u);
}

TEST(WallPiecesTest, ShortOrFewBeamPiecesNeedNotBeFound) {
  IdealScene near_stub;
  near_stub.wall({1.0, -0.1}, {1.0, 0.1});
  ASSERT_EQ(pieces_of(near_stub).size(), 1u);
  EXPECT_FALSE(pieces_of(near_stub)[0].is_resolvable());  // 0.2 m
  IdealScene far_stub;
  far_stub.wall({10.0, -0.2}, {10.0, 0.2});
  ASSERT_EQ(pieces_of(far_stub).size(), 1u);
  EXPECT_FALSE(pieces_of(far_stub)[0].is_resolvable());  // 2.3 degrees: at most 5 beams
}

TEST(WallPiecesTest, BeamsWithoutEchoShowNoWall) {
  IdealScene scene;
  scene.wall({2.0, -1.0}, {2.0, 1.0});
  LaserScan scan = scene.scan();
  for (double& range_m : scan.range_m) range_m = kNoEcho;
  EXPECT_TRUE(visible_wall_pieces(scene.truth(), scan).empty());
}

}  // namespace
}  // namespace scanbed
