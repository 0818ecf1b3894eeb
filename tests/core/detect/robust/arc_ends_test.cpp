// SPDX-License-Identifier: MIT
#include "core/detect/robust/arc_ends.hpp"

#include <gtest/gtest.h>

namespace scanbed {
namespace {

struct Ends {
  ArcEnd low;
  ArcEnd high;
};

// Ends of the arc of beams [first, last]; all echoes lie on one surface where `surface` says so.
Ends ends_of(const std::vector<double>& range_m, int first, int last, Stretch surface) {
  LaserScan scan;
  scan.range_m = range_m;
  Echoes echoes;
  EchoReader().read(scan, {}, echoes);
  const SurfacedScan surfaced{scan, echoes};
  return {arc_end_at(surfaced, surface, first, -1), arc_end_at(surfaced, surface, last, 1)};
}

TEST(ArcEndsTest, AFreeEndIsPassedByABeamThatSeesFarther) {
  const Ends ends = ends_of({5.0, 2.0, 1.9, 2.0, 5.0}, 1, 3, {1, 3});
  EXPECT_EQ(ends.low.kind, ArcEndKind::kFree);
  EXPECT_EQ(ends.high.kind, ArcEndKind::kFree);
  const ScanGeometry geometry;
  EXPECT_NEAR(ends.high.witness.ux, std::cos(geometry.bearing_rad(4)), 1e-12);
  EXPECT_NEAR(ends.high.witness.uy, std::sin(geometry.bearing_rad(4)), 1e-12);
}

TEST(ArcEndsTest, MixedBeamsAreNoWitnesses) {
  const Ends ends = ends_of({5.0, 2.1, 2.0, 1.9, 2.0, 2.12, 2.14, 5.0}, 2, 4, {2, 4});
  EXPECT_EQ(ends.low.kind, ArcEndKind::kFree);
  EXPECT_NEAR(ends.low.witness.ux, std::cos(ScanGeometry{}.bearing_rad(0)), 1e-12);
  EXPECT_EQ(ends.high.kind, ArcEndKind::kFree);
  EXPECT_NEAR(ends.high.witness.ux, std::cos(ScanGeometry{}.bearing_rad(7)), 1e-12);
}

TEST(ArcEndsTest, SomethingNearerAndTheEdgeOfViewMayHideTheRest) {
  const Ends ends = ends_of({2.0, 1.9, 2.0, 1.0}, 0, 2, {0, 2});
  EXPECT_EQ(ends.low.kind, ArcEndKind::kHidden);
  EXPECT_EQ(ends.high.kind, ArcEndKind::kHidden);
}

TEST(ArcEndsTest, ASurfaceThatGoesOnHoldsTheArc) {
  const Ends ends = ends_of({2.02, 2.0, 1.9, 2.0, 2.01, 2.02}, 1, 3, {0, 5});
  EXPECT_EQ(ends.low.kind, ArcEndKind::kAttached);
  EXPECT_EQ(ends.high.kind, ArcEndKind::kAttached);
}

TEST(ArcEndsTest, BeamsWithoutEchoSeeFarther) {
  const Ends ends = ends_of({kNoEcho, 2.0, 1.9, 2.0, kNoEcho}, 0, 2, {0, 2});
  EXPECT_EQ(ends.low.kind, ArcEndKind::kFree);
  EXPECT_EQ(ends.high.kind, ArcEndKind::kFree);
}

}  // namespace
}  // namespace scanbed
