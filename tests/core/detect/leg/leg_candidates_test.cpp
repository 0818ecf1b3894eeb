// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_candidates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;

class LegCandidatesTest : public ::testing::Test {
 protected:
  const LegCandidates& find(const LaserScan& scan) {
    LegBeamReader().read(scan, beams_);
    finder_.find(beams_, candidates_);
    return candidates_;
  }

  bool has_beams(int first, int last) const {
    return std::any_of(candidates_.runs.begin(), candidates_.runs.end(), [&](const EchoRun& run) {
      return beams_.beam[run.first] == first && beams_.beam[run.last] == last;
    });
  }

  LegBeams beams_;
  LegCandidateFinder finder_;
  LegCandidates candidates_;
};

LaserScan empty_scan() {
  LaserScan scan;
  scan.range_m.assign(scan.geometry.num_beams, kNoEcho);
  return scan;
}

TEST_F(LegCandidatesTest, EachLegOfTwoThatTouchIsACandidate) {
  IdealScene scene;
  const int left = scene.cylinder({2.0, 0.06}, 0.06, Primitive::kLeg);
  const int right = scene.cylinder({2.0, -0.06}, 0.06, Primitive::kLeg);
  const Truth truth = scene.truth();
  find(scene.scan());
  for (const int leg : {left, right}) {
    int first = -1;
    int last = -1;
    for (int i = 0; i < static_cast<int>(truth.beams.size()); ++i) {
      if (truth.beams[i].object != leg) continue;
      if (first < 0) first = i;
      last = i;
    }
    // The beam in the notch belongs to one of them.
    EXPECT_TRUE(has_beams(first, last) || has_beams(first + 1, last) || has_beams(first, last - 1));
  }
}

TEST_F(LegCandidatesTest, TwoMissingBeamsAreBridgedThreeAreNot) {
  LaserScan scan = empty_scan();
  for (const int beam : {100, 101, 104, 105}) scan.range_m[beam] = 2.0;
  find(scan);
  EXPECT_TRUE(has_beams(100, 105));
  scan.range_m[105] = kNoEcho;
  scan.range_m[104] = kNoEcho;
  scan.range_m[106] = scan.range_m[105 + 2] = 2.0;
  find(scan);
  EXPECT_FALSE(has_beams(100, 107));
  EXPECT_TRUE(has_beams(100, 101));
  EXPECT_TRUE(has_beams(106, 107));
}

TEST_F(LegCandidatesTest, SingleEchoesFarThingsAndWideThingsAreNone) {
  LaserScan scan = empty_scan();
  scan.range_m[50] = 2.0;
  for (int i = 100; i < 105; ++i) scan.range_m[i] = 6.5;
  for (int i = 200; i < 240; ++i) scan.range_m[i] = 3.0;  // 1.02 m
  EXPECT_TRUE(find(scan).runs.empty());
}

// Echoes of a narrow thing before a wall. At 3 m the middle segmentation cuts where neighbours lie more than
// 0.10 m + 1.5 beam spacings of 26 mm apart.
TEST_F(LegCandidatesTest, PartsOfAWallAreNoneButWhatStandsFreeBeforeIt) {
  for (const auto& [before_m, is_free] : {std::pair{0.08, false}, {0.18, true}}) {
    LaserScan scan = empty_scan();
    for (int i = 130; i < 210; ++i) scan.range_m[i] = 3.0;
    for (int i = 168; i < 172; ++i) scan.range_m[i] = 3.0 - before_m;
    find(scan);
    EXPECT_EQ(has_beams(168, 171), is_free) << before_m;
    EXPECT_EQ(candidates_.runs.size(), is_free ? 1u : 0u) << before_m;
  }
}

TEST_F(LegCandidatesTest, EveryCandidateIsThereOnceInRisingOrder) {
  IdealScene scene;
  scene.wall({4.0, -3.0}, {4.0, 3.0});
  for (int i = 0; i < 5; ++i) scene.cylinder({2.0 + 0.3 * i, -1.0 + 0.4 * i}, 0.05 + 0.01 * i);
  const LegCandidates& found = find(testing::with_noise(scene.scan(), 0.01, 5));
  ASSERT_GE(found.runs.size(), 5u);
  std::set<std::pair<int, int>> seen;
  std::pair<int, int> before{-1, -1};
  for (const EchoRun& run : found.runs) {
    const std::pair<int, int> here{run.first, run.last};
    EXPECT_LT(before, here);
    EXPECT_TRUE(seen.insert(here).second);
    before = here;
  }
}

TEST_F(LegCandidatesTest, SegmentationsCoverEveryEchoAndGetCoarser) {
  IdealScene scene;
  scene.wall({4.0, -3.0}, {5.0, 3.0});
  scene.cylinder({2.0, 0.3}, 0.06);
  const LegCandidates& found = find(testing::with_noise(scene.scan(), 0.02, 7));
  std::size_t num_before = beams_.beam.size() + 1;
  for (const LegSegmentation& segmentation : found.segmentations) {
    EXPECT_LE(segmentation.runs.size(), num_before);
    num_before = segmentation.runs.size();
    ASSERT_EQ(segmentation.run_of_echo.size(), beams_.beam.size());
    int next = 0;
    for (const EchoRun& run : segmentation.runs) {
      EXPECT_EQ(run.first, next);
      next = run.last + 1;
    }
    EXPECT_EQ(next, beams_.num_echoes());
  }
}

LaserScan scan_with_lost_echoes(unsigned seed) {
  IdealScene scene;
  scene.wall({4.0, -3.0}, {5.0, 3.0});
  for (int i = 0; i < 5; ++i) scene.cylinder({2.0 + 0.3 * i, -1.0 + 0.4 * i}, 0.05 + 0.01 * i);
  LaserScan scan = testing::with_noise(scene.scan(), 0.03, seed);
  std::mt19937 dice(seed);
  for (double& range_m : scan.range_m) {
    if (dice() % 8 == 0) range_m = kNoEcho;
  }
  return scan;
}

TEST_F(LegCandidatesTest, RunsEndWhereNeighboursLieTooFarApartAndNowhereElse) {
  constexpr double kGaps_m[] = {0.04, 0.10, 0.16};
  for (unsigned seed = 1; seed < 20; ++seed) {
    const LegCandidates& found = find(scan_with_lost_echoes(seed));
    for (int i = 0; i < LegCandidates::kNumSegmentations; ++i) {
      const LegSegmentation& segmentation = found.segmentations[i];
      for (int k = 1; k < beams_.num_echoes(); ++k) {
        const int num_steps = beams_.beam[k] - beams_.beam[k - 1];
        const double range_m = std::min(beams_.echo_range_m[k], beams_.echo_range_m[k - 1]);
        const double allowed_m = 1.5 * range_m * beams_.step_rad * num_steps;
        const bool is_cut = num_steps > 3 || beams_.distance_m(k - 1, k) - allowed_m >= kGaps_m[i];
        EXPECT_EQ(segmentation.run_of_echo[k], segmentation.run_of_echo[k - 1] + (is_cut ? 1 : 0));
        if (!is_cut) continue;
        EXPECT_EQ(segmentation.runs[segmentation.run_of_echo[k]].first, k);
      }
    }
  }
}

TEST_F(LegCandidatesTest, EveryInstructionSetFindsTheSame) {
  LegCandidateFinder plain(InstructionSet::kPlain);
  for (unsigned seed = 1; seed < 20; ++seed) {
    find(scan_with_lost_echoes(seed));
    LegCandidates found;
    plain.find(beams_, found);
    EXPECT_EQ(found.runs, candidates_.runs);
  }
}

TEST_F(LegCandidatesTest, ScansWithoutEchoesOrWithASingleOneHaveNone) {
  LaserScan scan = empty_scan();
  EXPECT_TRUE(find(scan).runs.empty());
  for (const int beam : {0, 1, 360}) {
    scan = empty_scan();
    scan.range_m[beam] = 2.0;
    EXPECT_TRUE(find(scan).runs.empty());
    EXPECT_EQ(candidates_.segmentations[0].runs, (std::vector<EchoRun>{{0, 0}}));
  }
  scan.range_m.clear();
  EXPECT_TRUE(find(scan).runs.empty());
}

}  // namespace
}  // namespace scanbed
