// SPDX-License-Identifier: MIT
#include "core/detect/robust/arc_finder.hpp"

#include <gtest/gtest.h>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;
using testing::with_noise;

// A scan cut into surfaces, with the lines of each.
struct Parsed {
  explicit Parsed(const LaserScan& s) : scan(s) {
    EchoReader().read(scan, options.surface, echoes);
    SurfaceSplitter().split(echoes, options.surface, runs);
    sums.build(echoes);
  }

  std::vector<Arc> arcs_of(int run) {
    std::vector<LinePiece> pieces;
    LineSplitter splitter;
    splitter.begin(echoes, sums, options.surface);
    splitter.add(runs.run(run));
    splitter.split();
    splitter.append_pieces(runs.run(run), pieces);
    std::vector<Arc> arcs;
    finder().find(runs.run(run), pieces, arcs);
    return arcs;
  }

  ArcFinder finder() const {
    ArcFinder finder;
    finder.begin({scan, echoes}, sums, options);
    return finder;
  }

  LaserScan scan;
  DetectorOptions options = robust_options();
  Echoes echoes;
  SurfaceRuns runs;
  RayLineSums sums;
};

TEST(ArcFinderTest, AFreeColumnIsOneArcWithoutDoubt) {
  IdealScene scene;
  scene.cylinder({2.0, 0.5}, 0.2);
  Parsed parsed(with_noise(scene.scan(), 0.005, 1));
  const std::vector<Arc> arcs = parsed.arcs_of(0);
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_NEAR((arcs[0].fit.cylinder.center_m - Eigen::Vector2d(2.0, 0.5)).norm(), 0.0, 0.02);
  EXPECT_GT(arcs[0].gain, arcs[0].doubt);
  EXPECT_DOUBLE_EQ(arcs[0].price, parsed.options.surface.arc_price);
}

TEST(ArcFinderTest, AnEndThatIsHiddenMakesAnArcDoubtful) {
  IdealScene scene;
  scene.cylinder({2.0, 0.5}, 0.2);
  LaserScan scan = with_noise(scene.scan(), 0.005, 1);
  int last = scan.num_beams() - 1;
  while (!scan.has_echo(last)) --last;
  for (int i = 0; i < 6; ++i) scan.range_m[last - i] = 1.0;  // something before its left edge
  Parsed parsed(scan);
  const std::vector<Arc> arcs = parsed.arcs_of(0);
  ASSERT_EQ(arcs.size(), 1u);
  const SurfaceOptions& o = parsed.options.surface;
  EXPECT_DOUBLE_EQ(arcs[0].price, o.arc_price);
  EXPECT_GE(arcs[0].doubt, o.unsure_arc_price + o.hidden_end_price);
}

TEST(ArcFinderTest, AWallIsNoArc) {
  IdealScene scene;
  scene.wall({3.0, -2.0}, {3.0, 2.0});
  for (unsigned seed = 0; seed < 20; ++seed) {
    Parsed parsed(with_noise(scene.scan(), 0.005, seed));
    EXPECT_TRUE(parsed.arcs_of(0).empty());
  }
}

// What noise leaves of a thin post is as likely round as flat, and nobody hangs a wall there.
TEST(ArcFinderTest, AThinPostThatStandsFreeIsRoundWhateverTheNoise) {
  int num_found = 0;
  constexpr int kNumScans = 200;
  for (unsigned seed = 0; seed < kNumScans; ++seed) {
    IdealScene scene;
    scene.wall({6.0, -3.0}, {6.0, 3.0});
    scene.cylinder({2.2, 0.0}, 0.08);
    Parsed parsed(with_noise(scene.scan(), 0.012, seed));
    for (int run = 0; run < parsed.runs.num_runs(); ++run) {
      for (const Arc& arc : parsed.arcs_of(run)) {
        const double off_m = (arc.fit.cylinder.center_m - Eigen::Vector2d(2.2, 0.0)).norm();
        if (off_m < 0.05 && arc.gain > arc.doubt) ++num_found;
      }
    }
  }
  // Half of its depth, 3 sigma at most, is hidden where beams pass its sides: a line and an arc often fit as
  // well.
  EXPECT_GE(num_found, 0.95 * kNumScans);
}

// A short wall from the edge of view to its end, where the last echo is mixed with what lies farther on.
TEST(ArcFinderTest, AMixedEchoAtItsEndDoesNotMakeAWallRound) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    IdealScene scene;
    scene.wall({-0.5, -1.0}, {0.1, -1.0});
    scene.wall({0.1, -1.3}, {2.0, -1.3});
    LaserScan scan = scene.scan();
    int last = 0;
    while (scan.range_m[last + 1] < 1.05) ++last;
    scan.range_m[last] += 0.03;
    Parsed parsed(with_noise(scan, 0.005, seed));
    for (const Arc& arc : parsed.arcs_of(0)) EXPECT_LE(arc.gain, arc.doubt) << seed;
  }
}

TEST(ArcFinderTest, TwoPartsOfAColumnAreOneArc) {
  IdealScene scene;
  scene.cylinder({3.0, 0.0}, 0.35);
  scene.cylinder({1.5, 0.0}, 0.05);
  Parsed parsed(with_noise(scene.scan(), 0.005, 1));
  ASSERT_EQ(parsed.runs.num_runs(), 3);
  const auto arc = parsed.finder().join(parsed.runs.run(0), parsed.runs.run(2), 60.0);
  ASSERT_TRUE(arc);
  EXPECT_EQ(arc->num_parts, 2);
  EXPECT_NEAR((arc->fit.cylinder.center_m - Eigen::Vector2d(3.0, 0.0)).norm(), 0.0, 0.02);
  EXPECT_NEAR(arc->fit.cylinder.radius_m, 0.35, 0.02);
  EXPECT_NEAR(arc->gain, 60.0 - arc->price - arc->fit.chi2, 1e-9);
  // What costs less than the arc is not given up for it.
  EXPECT_FALSE(parsed.finder().join(parsed.runs.run(0), parsed.runs.run(2), 18.0));
}

}  // namespace
}  // namespace scanbed
