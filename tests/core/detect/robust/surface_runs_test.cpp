// SPDX-License-Identifier: MIT
#include "core/detect/robust/surface_runs.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;
using testing::with_noise;

SurfaceRuns runs_of(const LaserScan& scan) {
  Echoes echoes;
  EchoReader().read(scan, {}, echoes);
  SurfaceRuns runs;
  SurfaceSplitter().split(echoes, {}, runs);
  return runs;
}

int num_runs_of(const IdealScene& scene) {
  return runs_of(scene.scan()).num_runs();
}

TEST(SurfaceRunsTest, AllInstructionSetsFindTheSameSurfaces) {
  IdealScene scene;
  scene.wall({4.0, -3.0}, {4.0, 3.0});
  for (int i = 0; i < 9; ++i) scene.cylinder({1.0 + 0.3 * i, -2.0 + 0.5 * i}, 0.02 * (i + 1));
  LaserScan scan = scene.scan();
  for (int num_beams = scan.num_beams(); num_beams > 0; num_beams -= num_beams > 20 ? 13 : 1) {
    scan.range_m.resize(num_beams);
    Echoes echoes;
    EchoReader().read(scan, {}, echoes);
    SurfaceRuns plain;
    SurfaceSplitter(InstructionSet::kPlain).split(echoes, {}, plain);
    EXPECT_EQ(runs_of(scan).begin, plain.begin);
  }
}

TEST(SurfaceRunsTest, AColumnBeforeAWallIsASurfaceOfItsOwn) {
  IdealScene scene;
  scene.wall({4.0, -3.0}, {4.0, 3.0});
  scene.cylinder({2.0, 0.0}, 0.25);
  EXPECT_EQ(num_runs_of(scene), 3);  // the wall goes on behind, but too far on to be the same
}

TEST(SurfaceRunsTest, AThinPostDoesNotCutTheWallBehindIt) {
  IdealScene scene;
  scene.wall({4.0, -3.0}, {4.0, 3.0});
  scene.cylinder({2.0, 0.0}, 0.02);
  EXPECT_EQ(num_runs_of(scene), 2);
}

TEST(SurfaceRunsTest, ADropoutDoesNotCut) {
  IdealScene scene;
  scene.wall({4.0, -3.0}, {4.0, 3.0});
  LaserScan scan = scene.scan();
  scan.range_m[180] = kNoEcho;
  EXPECT_EQ(runs_of(scan).num_runs(), 1);
}

TEST(SurfaceRunsTest, AWallAtGrazingIncidenceStaysOne) {
  IdealScene scene;
  scene.wall({0.0, 1.0}, {7.5, 1.0});  // at its end neighbours lie 0.5 m apart
  EXPECT_EQ(num_runs_of(scene), 1);
}

// The beams of each surface, counted from the first beam or from the last.
std::set<std::vector<int>> surfaces_of(const LaserScan& scan, bool from_last) {
  Echoes echoes;
  EchoReader().read(scan, {}, echoes);
  SurfaceRuns runs;
  SurfaceSplitter().split(echoes, {}, runs);
  runs.begin.push_back(echoes.size());
  std::set<std::vector<int>> surfaces;
  for (std::size_t i = 0; i + 1 < runs.begin.size(); ++i) {
    std::vector<int> beams(echoes.beam.begin() + runs.begin[i], echoes.beam.begin() + runs.begin[i + 1]);
    for (int& beam : beams) beam = from_last ? scan.num_beams() - 1 - beam : beam;
    std::sort(beams.begin(), beams.end());
    surfaces.insert(beams);
  }
  return surfaces;
}

TEST(SurfaceRunsTest, ARoomIsCutAtTheSamePlacesFromEitherSide) {
  for (const int num_beams : {61, 91, 181, 361}) {
    for (unsigned seed = 0; seed < 50; ++seed) {
      IdealScene scene({.num_beams = num_beams, .step_rad = kPi / (num_beams - 1)});
      const double shift_m = 0.03 * seed;
      scene.wall({0.0, -1.0 - shift_m}, {6.0, -1.0 - shift_m});  // grazing, up to the corners
      scene.wall({6.0, -1.0 - shift_m}, {6.0, 1.5});
      scene.wall({6.0, 1.5}, {0.0, 1.0});
      scene.cylinder({2.0 + shift_m, 0.2}, 0.2);
      LaserScan scan = with_noise(scene.scan(), 0.005, seed);
      const auto expected = surfaces_of(scan, false);
      std::reverse(scan.range_m.begin(), scan.range_m.end());
      EXPECT_EQ(surfaces_of(scan, true), expected) << num_beams << " beams, seed " << seed;
    }
  }
}

TEST(SurfaceRunsTest, NoWallIsSeenWhereManyBeamsAreLost) {
  IdealScene scene;
  scene.wall({4.0, -3.0}, {4.0, -0.5});
  scene.wall({4.0, 0.5}, {4.0, 3.0});  // an open door between
  EXPECT_EQ(num_runs_of(scene), 2);
}

TEST(SurfaceRunsTest, NoEchoesMakeNoSurfaces) {
  EXPECT_EQ(runs_of({}).num_runs(), 0);
}

RC_GTEST_PROP(SurfaceRunsTest, EveryEchoLiesOnOneSurfaceAndBeamsRise,
              (const std::vector<unsigned short>& ranges_cm)) {
  LaserScan scan;
  for (const auto range_cm : ranges_cm) scan.range_m.push_back((range_cm % 300) / 100.0);
  Echoes read;
  EchoReader().read(scan, {}, read);
  Echoes echoes = read;
  SurfaceRuns runs;
  SurfaceSplitter().split(echoes, {}, runs);
  std::vector<int> seen = echoes.beam;
  for (int i = 0; i < runs.num_runs(); ++i) {
    RC_ASSERT(std::is_sorted(seen.begin() + runs.begin[i], seen.begin() + runs.begin[i + 1]));
  }
  for (int k = 0; k < echoes.size(); ++k) {  // what belongs to a beam moves with it
    RC_ASSERT(echoes.range_m[k] == scan.range_m[seen[k]]);
    RC_ASSERT(echoes.x_m[k] == echoes.range_m[k] * echoes.directions.x(seen[k]));
    RC_ASSERT(echoes.y_m[k] == echoes.range_m[k] * echoes.directions.y(seen[k]));
  }
  std::sort(seen.begin(), seen.end());
  RC_ASSERT(seen == read.beam);
}

}  // namespace
}  // namespace scanbed
