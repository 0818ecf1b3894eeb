// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_features.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using Eigen::Vector2d;
using testing::IdealScene;

struct Read {
  LegBeams beams;
  LegCandidates candidates;
  LegFeatureTable table;

  explicit Read(const LaserScan& scan, const Features& surfaces = {}) {
    LegBeamReader().read(scan, beams);
    LegCandidateFinder().find(beams, candidates);
    LegFeatureReader().read(beams, candidates, surfaces, table);
  }
  double value(LegFeature feature, std::size_t candidate) const {
    return static_cast<double>(table.at(static_cast<int>(feature), static_cast<int>(candidate)));
  }
  Vector2d point_m(int echo) const { return {beams.echo_x_m[echo], beams.echo_y_m[echo]}; }
};

LaserScan furnished_scan(unsigned seed) {
  IdealScene scene;
  scene.wall({-1.0, -2.5}, {4.5, -2.5});
  scene.wall({4.5, -2.5}, {4.5, 1.0});
  scene.wall({1.5, 2.0}, {2.3, 2.6});
  scene.cylinder({2.0, 0.3}, 0.06);
  scene.cylinder({2.1, 0.0}, 0.07);
  scene.cylinder({0.6, -0.3}, 0.05);
  scene.cylinder({3.0, -2.2}, 0.05);
  scene.cylinder({1.4, -1.5}, 0.02);
  scene.cylinder({0.0, 1.2}, 0.3);
  LaserScan scan = testing::with_noise(scene.scan(), 0.006, seed);
  std::mt19937 dice(seed);
  for (double& range_m : scan.range_m) {
    if (dice() % 40 == 0) range_m = kNoEcho;
  }
  return scan;
}

// What the header says, beam by beam.
class PlainFeatures {
 public:
  PlainFeatures(const Read& read, const LaserScan& scan) : read_(read), scan_(scan) {}

  std::map<LegFeature, double> of(std::size_t candidate) {
    run_ = read_.candidates.runs[candidate];
    first_ = read_.beams.beam[run_.first];
    last_ = read_.beams.beam[run_.last];
    n_ = run_.size();
    center_ = Vector2d::Zero();
    range_ = 0.0;
    for (int k = run_.first; k <= run_.last; ++k) {
      center_ += read_.point_m(k) / n_;
      range_ += read_.beams.echo_range_m[k] / n_;
    }
    spacing_ = range_ * scan_.geometry.step_rad;
    std::map<LegFeature, double> values;
    shape(values);
    near(values);
    small(values);
    beside(values);
    return values;
  }

 private:
  void shape(std::map<LegFeature, double>& v) const {
    const Vector2d a = read_.point_m(run_.first);
    const Vector2d b = read_.point_m(run_.last);
    const double width = (b - a).norm();
    v[LegFeature::kNumPoints] = n_;
    v[LegFeature::kWidth] = width;
    v[LegFeature::kFilled] = n_ * spacing_ / 0.13;
    v[LegFeature::kRange] = range_;
    const Vector2d along = (b - a) / width;
    Vector2d towards(-along.y(), along.x());
    if (towards.dot(-a) < 0.0) towards = -towards;
    double bow = 0.0;
    double variance = 0.0;
    double step2 = 0.0;
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    for (int k = run_.first; k <= run_.last; ++k) {
      bow += (read_.point_m(k) - a).dot(towards) / n_;
      variance += std::pow(read_.beams.echo_range_m[k] - range_, 2) / n_;
      const Vector2d d = read_.point_m(k) - center_;
      covariance += d * d.transpose() / n_;
      if (k > run_.first)
        step2 += std::pow(read_.beams.echo_range_m[k] - read_.beams.echo_range_m[k - 1], 2) / (n_ - 1);
    }
    v[LegFeature::kBow] = bow / (width + 0.02);
    v[LegFeature::kTilt] =
        std::abs(read_.beams.echo_range_m[run_.last] - read_.beams.echo_range_m[run_.first]) / (width + 0.02);
    v[LegFeature::kRangeStd] = std::sqrt(variance);
    v[LegFeature::kStep] = std::sqrt(step2);
    const auto solver =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>().computeDirect(covariance, Eigen::EigenvaluesOnly);
    v[LegFeature::kLineResidual] = std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
  }

  void near(std::map<LegFeature, double>& v) const {
    double count30 = 0, count50 = 0, count100 = 0, wall100 = 0, nearest = 1.0, wall = 1.0;
    const LegSegmentation& middle = read_.candidates.segmentations[1];
    for (int k = 0; k < read_.beams.num_echoes(); ++k) {
      if (k >= run_.first && k <= run_.last) continue;
      const double d = (read_.point_m(k) - center_).norm();
      const bool on_wall = middle.width_m[middle.run_of_echo[k]] > 0.5;
      count30 += d < 0.3 ? 1 : 0;
      count50 += d < 0.5 ? 1 : 0;
      count100 += d < 1.0 ? 1 : 0;
      wall100 += on_wall && d < 1.0 ? 1 : 0;
      nearest = std::min(nearest, d);
      if (on_wall) wall = std::min(wall, d);
    }
    v[LegFeature::kNear30] = count30 * spacing_;
    v[LegFeature::kNear50] = count50 * spacing_;
    v[LegFeature::kNear100] = count100 * spacing_;
    v[LegFeature::kNearWall100] = wall100 * spacing_;
    v[LegFeature::kNearest] = nearest;
    v[LegFeature::kNearestWall] = wall;
  }

  void small(std::map<LegFeature, double>& v) const {
    const LegSegmentation& middle = read_.candidates.segmentations[1];
    double count = 0, nearest = 1.5, width = -1.0;
    for (std::size_t i = 0; i < middle.runs.size(); ++i) {
      const EchoRun& run = middle.runs[i];
      if (run.size() < 2 || middle.width_m[i] < 0.008 || middle.width_m[i] > 0.25) continue;
      if (run.last >= run_.first && run.first <= run_.last) continue;
      Vector2d p = Vector2d::Zero();
      for (int k = run.first; k <= run.last; ++k) p += read_.point_m(k) / run.size();
      const double d = (p - center_).norm();
      if (d < 1.0) ++count;
      if (d >= nearest) continue;
      nearest = d;
      width = middle.width_m[i];
    }
    v[LegFeature::kNumSmall] = count;
    v[LegFeature::kNearestSmall] = nearest;
    v[LegFeature::kSmallWidth] = width;
  }

  double jump(int beam, int echo) const {
    if (beam < 0 || beam >= scan_.num_beams()) return 0.0;
    return std::clamp(scan_.range_m[beam] - read_.beams.echo_range_m[echo], -2.0, 2.0);
  }

  void beside(std::map<LegFeature, double>& v) const {
    const int half = std::max(1, static_cast<int>(std::ceil(0.5 / spacing_)));
    double total = 0, open25 = 0, open60 = 0, hidden = 0, nearest = 2.0, behind = 2.0;
    for (int i = first_ - half; i <= last_ + half; ++i) {
      if ((i >= first_ && i <= last_) || i < 0 || i >= scan_.num_beams()) continue;
      const double farther = scan_.range_m[i] - range_;
      ++total;
      open25 += farther > 0.25 ? 1 : 0;
      open60 += farther > 0.6 ? 1 : 0;
      hidden += farther < -0.15 ? 1 : 0;
      nearest = std::min(nearest, std::abs(farther));
      if (farther > -0.1) behind = std::min(behind, farther);
    }
    v[LegFeature::kOpen25] = open25 / total;
    v[LegFeature::kOpen60] = open60 / total;
    v[LegFeature::kHidden] = hidden / total;
    v[LegFeature::kNearestBeside] = nearest;
    v[LegFeature::kNearestBehind] = behind;
    const double left = jump(first_ - 1, run_.first);
    const double right = jump(last_ + 1, run_.last);
    v[LegFeature::kLeastJump] = std::min(left, right);
    v[LegFeature::kLargestJump] = std::max(left, right);
  }

  const Read& read_;
  const LaserScan& scan_;
  EchoRun run_;
  int first_ = 0, last_ = 0, n_ = 0;
  Vector2d center_ = Vector2d::Zero();
  double range_ = 0.0, spacing_ = 0.0;
};

TEST(LegFeaturesTest, AreWhatAPlainLoopOverThePointsFinds) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const LaserScan scan = furnished_scan(seed);
    const Read read(scan);
    PlainFeatures plain(read, scan);
    ASSERT_GE(read.candidates.runs.size(), 10u);
    for (std::size_t c = 0; c < read.candidates.runs.size(); ++c) {
      for (const auto& [feature, expected] : plain.of(c)) {
        // Floats, and sums of squares of metres whose differences are millimetres.
        EXPECT_NEAR(read.value(feature, c), expected, 2e-4 * std::max(1.0, std::abs(expected)))
            << static_cast<int>(feature) << " of candidate " << c << ", seed " << seed;
      }
    }
  }
}

TEST(LegFeaturesTest, ACircleAloneHasItsRadiusAndTheInscribedAngleOfItsChord) {
  IdealScene scene;
  scene.cylinder({1.5, 0.2}, 0.08);
  const Read read(scene.scan());
  std::size_t widest = 0;
  for (std::size_t c = 0; c < read.candidates.runs.size(); ++c) {
    if (read.candidates.runs[c].size() > read.candidates.runs[widest].size()) widest = c;
  }
  EXPECT_NEAR(read.value(LegFeature::kCircleRadius, widest), 0.08, 1e-3);
  EXPECT_NEAR(read.value(LegFeature::kCircleResidual, widest), 0.0, 1e-4);
  // Inscribed angles over a chord w of a circle r are pi - asin(w / 2r) where the arc is less than half of
  // it.
  const double half_chord = read.value(LegFeature::kWidth, widest) / 2;
  EXPECT_NEAR(read.value(LegFeature::kInscribed, widest), -std::sqrt(1.0 - std::pow(half_chord / 0.08, 2)),
              1e-3);
}

// A column whose middle something thin hides: its beams lie on both sides of that.
TEST(LegFeaturesTest, EachCandidateKnowsTheCircleThatItsMiddleLiesOn) {
  IdealScene scene;
  scene.cylinder({3.0, 0.0}, 0.25);
  scene.cylinder({1.5, 0.0}, 0.04);
  scene.cylinder({2.0, 1.5}, 0.06);
  const LaserScan scan = scene.scan();
  const auto beams_nearer = [&](double from_m, double to_m) {
    BeamSpan span{scan.num_beams(), -1};
    int count = 0;
    for (int i = 0; i < scan.num_beams(); ++i) {
      if (scan.range_m[i] < from_m || scan.range_m[i] > to_m) continue;
      span = {std::min(span.first, i), i};
      ++count;
    }
    return std::pair(span, count);
  };
  const auto [column_beams, column_echoes] = beams_nearer(2.7, 3.1);
  const auto [post_beams, post_echoes] = beams_nearer(1.4, 1.6);
  const Circle column{.beams = column_beams, .center_m = {3.0, 0.0}, .radius_m = 0.25};
  const Circle post{.beams = post_beams, .center_m = {1.5, 0.0}, .radius_m = 0.04};
  const Features column_first{.circles = {column}, .doubtful_circles = {post}};
  const Features post_first{.circles = {post}, .doubtful_circles = {column}};
  for (const Features& surfaces : {column_first, post_first}) {
    const Read read(scan, surfaces);
    int num_on_column = 0;
    for (std::size_t c = 0; c < read.candidates.runs.size(); ++c) {
      const EchoRun& run = read.candidates.runs[c];
      const Vector2d middle_m = read.point_m((run.first + run.last) / 2);
      const bool on_column = std::abs(middle_m.y()) < 0.5 && middle_m.x() > 2.0;
      const bool on_post = std::abs(middle_m.y()) < 0.5 && middle_m.x() < 2.0;
      num_on_column += on_column ? 1 : 0;
      const double echoes = on_column ? column_echoes : on_post ? post_echoes : run.size();
      EXPECT_NEAR(read.value(LegFeature::kArcRadius, c), on_column ? 0.25 : on_post ? 0.04 : 0.0, 1e-6);
      EXPECT_NEAR(read.value(LegFeature::kArcShare, c), run.size() / echoes, 1e-6);
    }
    EXPECT_GE(num_on_column, 2);
  }
}

TEST(LegFeaturesTest, AHollowHasItsCentreInFront) {
  LaserScan scan;
  scan.range_m.assign(scan.geometry.num_beams, kNoEcho);
  for (int i = -6; i <= 6; ++i) {  // on a circle of radius 0.2 m about a point 1.8 m ahead, seen from within
    const double bearing_rad = scan.geometry.bearing_rad(180 + i);
    const double off = 1.8 * std::sin(bearing_rad);
    scan.range_m[180 + i] = 1.8 * std::cos(bearing_rad) + std::sqrt(0.04 - off * off);
  }
  const Read read(scan);
  ASSERT_FALSE(read.candidates.runs.empty());
  for (std::size_t c = 0; c < read.candidates.runs.size(); ++c) {
    if (read.candidates.runs[c].size() != 13) continue;
    EXPECT_NEAR(read.value(LegFeature::kCircleRadius, c), -0.2, 2e-3);
    EXPECT_LT(read.value(LegFeature::kBow, c), 0.0);
  }
}

// Over all features, between candidates of the same echoes.
double largest_difference(const Read& a, const Read& b, bool mirrored) {
  EXPECT_EQ(a.candidates.runs.size(), b.candidates.runs.size());
  double largest = 0.0;
  for (std::size_t c = 0; c < a.candidates.runs.size(); ++c) {
    const EchoRun& run = a.candidates.runs[c];
    const int n = a.beams.num_echoes();
    const EchoRun twin = mirrored ? EchoRun{n - 1 - run.last, n - 1 - run.first} : run;
    const auto found = std::find(b.candidates.runs.begin(), b.candidates.runs.end(), twin);
    if (found == b.candidates.runs.end()) {
      ADD_FAILURE() << "no twin of candidate " << c;
      continue;
    }
    const auto d = found - b.candidates.runs.begin();
    for (int f = 0; f < kNumLegFeatures; ++f)
      largest = std::max(largest, std::abs(static_cast<double>(a.table.at(f, static_cast<int>(c)) -
                                                               b.table.at(f, static_cast<int>(d)))));
  }
  return largest;
}

TEST(LegFeaturesTest, EveryInstructionSetGivesTheSameBits) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Read read(furnished_scan(seed));
    LegFeatureTable plain;
    LegFeatureReader(InstructionSet::kPlain).read(read.beams, read.candidates, {}, plain);
    for (int f = 0; f < kNumLegFeatures; ++f) {
      for (int c = 0; c < plain.num_candidates(); ++c) EXPECT_EQ(plain.at(f, c), read.table.at(f, c));
    }
  }
}

TEST(LegFeaturesTest, AMirroredScanHasTheSameFeatures) {
  const LaserScan scan = furnished_scan(11);
  LaserScan mirrored = scan;
  std::reverse(mirrored.range_m.begin(), mirrored.range_m.end());
  EXPECT_LT(largest_difference(Read(scan), Read(mirrored), true), 1e-3);
}

TEST(LegFeaturesTest, ATurnedScanHasTheSameFeatures) {
  const LaserScan scan = furnished_scan(12);
  LaserScan turned = scan;
  turned.geometry.first_rad += 1.1;
  EXPECT_LT(largest_difference(Read(scan), Read(turned), false), 1e-3);
}

}  // namespace
}  // namespace scanbed
