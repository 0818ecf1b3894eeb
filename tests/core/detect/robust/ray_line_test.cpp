// SPDX-License-Identifier: MIT
#include "core/detect/robust/ray_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;
using testing::with_noise;

struct Fitted {
  Echoes echoes;
  RayLine line;
};

Fitted fit_whole_scan(const LaserScan& scan) {
  Fitted fitted;
  EchoReader().read(scan, {}, fitted.echoes);
  RayLineSums sums;
  sums.build(fitted.echoes);
  fitted.line = sums.fit({0, fitted.echoes.size() - 1});
  return fitted;
}

LaserScan wall_scan() {
  IdealScene scene;
  scene.wall({2.0, -1.0}, {3.0, 1.5});
  return scene.scan();
}

TEST(RayLineTest, AnExactWallHasItsNormalOverItsDistanceAndNoResidual) {
  const RayLine line = fit_whole_scan(wall_scan()).line;
  // Through (2, -1) along (1, 2.5): normal (2.5, -1), offset 6.
  EXPECT_NEAR(line.inverse_m.x(), 2.5 / 6.0, 1e-9);
  EXPECT_NEAR(line.inverse_m.y(), -1.0 / 6.0, 1e-9);
  EXPECT_NEAR(line.chi2, 0.0, 1e-4);
}

TEST(RayLineTest, NoiseLeavesAChiSquaredOfItsDegreesOfFreedom) {
  double ratio = 0.0;
  constexpr int kRepeats = 50;
  for (int seed = 0; seed < kRepeats; ++seed) {
    Fitted fitted = fit_whole_scan(with_noise(wall_scan(), 0.006, static_cast<unsigned>(seed)));
    const double true_sigmas = fitted.echoes.range_noise_m / 0.006;
    ratio += fitted.line.chi2 * true_sigmas * true_sigmas / (fitted.echoes.size() - 2) / kRepeats;
  }
  EXPECT_NEAR(ratio, 1.0, 0.1);  // 50 runs of some 110 echoes: 4 sigma are 0.08
}

TEST(RayLineTest, TheDirectionIsAsUncertainAsPositionsAlongTheWallLeaveIt) {
  IdealScene scene;
  scene.wall({4.0, -0.3}, {4.0, 0.3});  // seen head-on: errors of range are errors across the wall
  const Fitted fitted = fit_whole_scan(scene.scan());
  double sum_m2 = 0.0;
  for (int k = 0; k < fitted.echoes.size(); ++k) sum_m2 += fitted.echoes.y_m[k] * fitted.echoes.y_m[k];
  const double expected_rad2 = fitted.echoes.range_noise_m * fitted.echoes.range_noise_m / sum_m2;
  // Beams at 4.3 degrees see the wall from its side: 0.6 % of a variance.
  EXPECT_NEAR(fitted.line.direction_rad2, expected_rad2, 0.01 * expected_rad2);
}

TEST(RayLineTest, TheUncertaintyOfADirectionIsThatOfItsErrors) {
  double sum_rad2 = 0.0;
  double expected_rad2 = 0.0;
  constexpr int kRepeats = 400;
  for (int seed = 0; seed < kRepeats; ++seed) {
    const Fitted fitted = fit_whole_scan(with_noise(wall_scan(), 0.006, static_cast<unsigned>(seed)));
    const double error_rad =
        std::atan2(fitted.line.inverse_m.y(), fitted.line.inverse_m.x()) - std::atan2(-1.0, 2.5);
    const double true_sigmas = 0.006 / fitted.echoes.range_noise_m;
    sum_rad2 += error_rad * error_rad / kRepeats;
    expected_rad2 += fitted.line.direction_rad2 * true_sigmas * true_sigmas / kRepeats;
  }
  EXPECT_NEAR(sum_rad2 / expected_rad2, 1.0, 0.28);  // 4 sigma of a variance from 400 errors
}

double chi2_of_two(const RayLineSums& sums, Stretch places, int cut) {
  const auto chi2 = [&](Stretch part) { return part.size() == 1 ? 0.0 : sums.fit(part).chi2; };
  return chi2({places.first, cut}) + chi2({cut + 1, places.last});
}

// Of the cuts from the first on, by trying each.
int best_cut_by_trial(const RayLineSums& sums, Stretch places, int first_cut) {
  const int end = std::min(first_cut + RayLineSums::kNumCuts, places.last);
  int best = first_cut;
  for (int cut = first_cut + 1; cut < end; ++cut) {
    if (chi2_of_two(sums, places, cut) < chi2_of_two(sums, places, best)) best = cut;
  }
  return best;
}

TEST(RayLineTest, TheBestCutIsTheOneFoundByTrial) {
  IdealScene scene;
  scene.wall({2.0, -1.0}, {2.5, 0.2});
  scene.wall({2.5, 0.2}, {2.2, 1.0});
  for (unsigned seed = 0; seed < 20; ++seed) {
    Echoes echoes;
    EchoReader().read(with_noise(scene.scan(), 0.01, seed), {}, echoes);
    RayLineSums sums;
    sums.build(echoes);
    for (const int size : {3, 4, 5, 8, 9, 10, 40, echoes.size()}) {
      const Stretch places{echoes.size() - size, echoes.size() - 1};
      for (int first_cut = places.first; first_cut < places.last; ++first_cut) {
        const int best = best_cut_by_trial(sums, places, first_cut);
        // The last window is moved to lie in the stretch as a whole pair of cuts.
        const RayLineSums::Cut cut = sums.best_cut(places, first_cut);
        if (first_cut + 1 < places.last) {
          EXPECT_EQ(cut.place, best);
        }
        EXPECT_LE(cut.chi2(), chi2_of_two(sums, places, best) + 1e-4);
        EXPECT_NEAR(cut.chi2(), chi2_of_two(sums, places, cut.place), 1e-4);
        EXPECT_NEAR(cut.chi2_before, sums.chi2_of({places.first, cut.place}), 1e-4);
      }
    }
  }
}

TEST(RayLineTest, AllInstructionSetsFindTheSameCutsToTheBit) {
  const Fitted whole = fit_whole_scan(with_noise(wall_scan(), 0.02, 5));
  RayLineSums plain(InstructionSet::kPlain);
  RayLineSums widest;
  plain.build(whole.echoes);
  widest.build(whole.echoes);
  for (const int size : {3, 4, 5, 6, 7, 8, 9, 10, 40}) {
    for (int first_cut = 7; first_cut < 6 + size; ++first_cut) {
      const RayLineSums::Cut a = plain.best_cut({7, 6 + size}, first_cut);
      const RayLineSums::Cut b = widest.best_cut({7, 6 + size}, first_cut);
      EXPECT_EQ(a.place, b.place);
      EXPECT_EQ(a.chi2_before, b.chi2_before);
      EXPECT_EQ(a.chi2_after, b.chi2_after);
    }
  }
}

TEST(RayLineTest, AnEchoAtAnEndThatIsOffTheLineIsCutOff) {
  IdealScene scene;
  scene.wall({2.0, -1.0}, {2.5, 1.0});
  for (const bool at_begin : {true, false}) {
    Echoes echoes;
    EchoReader().read(scene.scan(), {}, echoes);
    const int last = echoes.size() - 1;
    const int off = at_begin ? 0 : last;
    for (std::vector<double>* column : {&echoes.range_m, &echoes.x_m, &echoes.y_m}) (*column)[off] *= 1.1;
    RayLineSums sums;
    sums.build(echoes);
    const RayLineSums::Cut cut = sums.best_cut({0, last}, at_begin ? 0 : last - RayLineSums::kNumCuts);
    // With one neighbour it would make a line without residual too.
    EXPECT_NEAR(cut.place, at_begin ? 0.5 : last - 1.5, 0.5);
    EXPECT_NEAR(cut.chi2(), 0.0, 1e-4);
  }
}

TEST(RayLineTest, ChiSquaredIsThatOfTheFit) {
  const Fitted whole = fit_whole_scan(with_noise(wall_scan(), 0.005, 4));
  RayLineSums sums;
  sums.build(whole.echoes);
  for (const Stretch& places : {Stretch{0, 1}, Stretch{3, 20}, Stretch{0, whole.echoes.size() - 1}}) {
    EXPECT_NEAR(sums.chi2_of(places), sums.fit(places).chi2, 1e-4);
  }
  EXPECT_EQ(sums.chi2_of({5, 5}), 0.0);
}

TEST(RayLineTest, TwoStretchesAreFittedAsOne) {
  const Fitted whole = fit_whole_scan(with_noise(wall_scan(), 0.005, 4));
  RayLineSums sums;
  sums.build(whole.echoes);
  const double chi2 = sums.fit_both({0, 9}, {10, whole.echoes.size() - 1}).chi2;
  EXPECT_NEAR(chi2, whole.line.chi2, 1e-6 * chi2);
}

}  // namespace
}  // namespace scanbed
