// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_arcs.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;

LegBeams beams_of(const LaserScan& scan) {
  LegBeams beams;
  LegBeamReader().read(scan, beams);
  return beams;
}

// A column whose middle a post hides: one circle has beams on both sides of the other.
TEST(LegArcsTest, ABeamKnowsTheCircleThatItMetAndNoOther) {
  IdealScene scene;
  scene.cylinder({3.0, 0.0}, 0.25);
  scene.cylinder({1.5, 0.0}, 0.04);
  const LaserScan scan = scene.scan();
  BeamSpan of_column{scan.num_beams(), -1};
  BeamSpan of_post = of_column;
  int num_on_column = 0;
  for (int beam = 0; beam < scan.num_beams(); ++beam) {
    if (!scan.has_echo(beam)) continue;
    const bool on_column = scan.range_m[beam] > 2.0;
    BeamSpan& span = on_column ? of_column : of_post;
    span = {std::min(span.first, beam), beam};
    num_on_column += on_column ? 1 : 0;
  }
  const Circle column{.beams = of_column, .center_m = {3.0, 0.0}, .radius_m = 0.25};
  const Circle post{.beams = of_post, .center_m = {1.5, 0.0}, .radius_m = 0.04};
  ASSERT_LT(of_column.first, of_post.first);
  ASSERT_GT(of_column.last, of_post.last);
  LegArcs arcs;
  arcs.mark(beams_of(scan), {.circles = {column}, .doubtful_circles = {post}});
  for (int beam = 0; beam < scan.num_beams(); ++beam) {
    const LegArc* arc = arcs.at(beam);
    ASSERT_EQ(arc != nullptr, scan.has_echo(beam)) << beam;
    if (arc == nullptr) continue;
    const bool on_column = scan.range_m[beam] > 2.0;
    EXPECT_FLOAT_EQ(arc->radius_m, on_column ? 0.25F : 0.04F) << beam;
    EXPECT_EQ(arc->num_echoes, on_column ? num_on_column : of_post.last - of_post.first + 1);
  }
}

TEST(LegArcsTest, EachScanBeginsAnew) {
  IdealScene scene;
  scene.cylinder({2.0, 0.0}, 0.1);
  const LegBeams beams = beams_of(scene.scan());
  const int ahead = beams.num_beams / 2;
  const Circle circle{.beams = {ahead - 1, ahead + 1}, .center_m = {2.0, 0.0}, .radius_m = 0.1};
  LegArcs arcs;
  arcs.mark(beams, {.circles = {circle}});
  EXPECT_NE(arcs.at(ahead), nullptr);
  arcs.mark(beams, {});
  EXPECT_EQ(arcs.at(ahead), nullptr);
}

}  // namespace
}  // namespace scanbed
