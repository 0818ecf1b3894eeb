// SPDX-License-Identifier: MIT
// What every detector and preset has to do whatever its method: turn with a turned scan, mirror with a
// mirrored one, and take any scan at all.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "core/detect/feature_detector.hpp"
#include "core/detect/presets.hpp"
#include "core/geometry/polar.hpp"
#include "tests/support/ideal_scene.hpp"

namespace scanbed {
namespace {

using testing::IdealScene;
using testing::with_noise;

// Rounding may change the last digits, and with them which of two equal splits is taken.
constexpr double kSame_m = 1e-6;
// An arc is scored against the lines that it replaces, whose cuts depend on the side from which they are
// sought.
constexpr double kSameScore = 0.02;

LaserScan room(unsigned seed, const ScanGeometry& geometry = {}) {
  const double shift_m = 0.07 * seed;  // so that no two rooms are cut alike by the beams
  IdealScene scene(geometry);
  scene.wall({-1.0, -2.5 - shift_m}, {4.5, -2.5 - shift_m});
  scene.wall({4.5, -2.5 - shift_m}, {4.5, 2.0});
  scene.wall({4.5, 2.0}, {-1.0, 2.0 + shift_m});
  scene.cylinder({2.5 - shift_m, 0.9}, 0.25);
  scene.cylinder({3.0, -1.0 + shift_m}, 0.15);
  scene.cylinder({1.6, -0.45 + 0.3 * shift_m}, 0.06, Primitive::kLeg);
  scene.cylinder({1.6, -0.75 + 0.3 * shift_m}, 0.06, Primitive::kLeg);
  return with_noise(scene.scan(), 0.005, seed);
}

class ConformanceTest : public ::testing::TestWithParam<std::string> {
 protected:
  Features detect(const LaserScan& scan) const {
    return FeatureDetector(*preset_options(GetParam())).detect(scan);
  }
};

using Transform = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

// One behind the other by their first beams; read from the other side, by their last. Those of a column that
// something nearer cuts in two lie on both sides of that.
Features by_last_beam(Features features) {
  const auto sort = [](auto& list) {
    std::sort(list.begin(), list.end(),
              [](const auto& a, const auto& b) { return a.beams.last < b.beams.last; });
  };
  sort(features.lines);
  sort(features.circles);
  sort(features.legs);
  return features;
}

// Features in the order of their beams against those of another scan, `turned` from one frame into the other.
void expect_same(const Features& plain, const Features& as_found, const Transform& turned, bool is_reversed) {
  const Features other = is_reversed ? by_last_beam(as_found) : as_found;
  ASSERT_EQ(plain.lines.size(), other.lines.size());
  ASSERT_EQ(plain.circles.size(), other.circles.size());
  ASSERT_EQ(plain.legs.size(), other.legs.size());
  const auto place = [&](std::size_t i, std::size_t size) { return is_reversed ? size - 1 - i : i; };
  for (std::size_t i = 0; i < plain.lines.size(); ++i) {
    const Line& a = plain.lines[i];
    const Line& b = other.lines[place(i, plain.lines.size())];
    EXPECT_NEAR((turned(a.left_m) - (is_reversed ? b.right_m : b.left_m)).norm(), 0.0, kSame_m);
    EXPECT_NEAR((turned(a.right_m) - (is_reversed ? b.left_m : b.right_m)).norm(), 0.0, kSame_m);
    EXPECT_EQ(a.num_points, b.num_points);
  }
  for (std::size_t i = 0; i < plain.circles.size(); ++i) {
    const Circle& a = plain.circles[i];
    const Circle& b = other.circles[place(i, plain.circles.size())];
    EXPECT_NEAR((turned(a.center_m) - b.center_m).norm(), 0.0, kSame_m);
    EXPECT_NEAR(a.radius_m, b.radius_m, kSame_m);
    EXPECT_NEAR(a.score, b.score, kSameScore);
  }
  for (std::size_t i = 0; i < plain.legs.size(); ++i) {
    const Leg& a = plain.legs[i];
    const Leg& b = other.legs[place(i, plain.legs.size())];
    EXPECT_NEAR((turned(a.middle_m) - b.middle_m).norm(), 0.0, kSame_m);
    EXPECT_NEAR(a.score, b.score, kSame_m);
  }
}

TEST_P(ConformanceTest, FindsSomethingToCompare) {
  const Features features = detect(room(1));
  EXPECT_GE(features.lines.size(), 3u);
  EXPECT_GE(features.circles.size(), 1u);
}

TEST_P(ConformanceTest, ATurnedScanGivesTurnedFeatures) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    LaserScan scan = room(seed);
    const Features plain = detect(scan);
    for (const double turn_rad : {0.3, -1.1, 2.5}) {
      LaserScan turned = scan;
      turned.geometry.first_rad += turn_rad;
      const Pose2 X_TS{{0.0, 0.0}, turn_rad};
      expect_same(
          plain, detect(turned), [&](const Eigen::Vector2d& p) { return X_TS * p; }, false);
    }
  }
}

TEST_P(ConformanceTest, AMirroredScanGivesMirroredFeatures) {
  for (const int num_beams : {91, 181, 361, 721}) {
    for (unsigned seed = 0; seed < 20; ++seed) {
      LaserScan scan = room(seed, {.num_beams = num_beams, .step_rad = kPi / (num_beams - 1)});
      const Features plain = detect(scan);
      std::reverse(scan.range_m.begin(), scan.range_m.end());
      expect_same(
          plain, detect(scan), [](const Eigen::Vector2d& p) { return Eigen::Vector2d(p.x(), -p.y()); }, true);
    }
  }
}

TEST_P(ConformanceTest, ASensorThatTurnsClockwiseFindsTheSame) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    LaserScan scan = room(seed);
    const Features plain = detect(scan);
    std::reverse(scan.range_m.begin(), scan.range_m.end());
    scan.geometry.first_rad = -scan.geometry.first_rad;
    scan.geometry.step_rad = -scan.geometry.step_rad;
    expect_same(
        plain, detect(scan), [](const Eigen::Vector2d& p) { return p; }, true);
  }
}

// What some drivers write for no echo is a number.
TEST_P(ConformanceTest, BeamsWithoutEchoAtTheEndsShiftFeaturesAlone) {
  for (const auto& [seed, no_echo_m] :
       {std::pair{0u, kInvalid}, {1u, kNoEcho}, {2u, kTooClose}, {3u, 0.0}, {4u, -1.0}, {5u, 65.535e3}}) {
    LaserScan scan = room(seed);
    const Features plain = detect(scan);
    constexpr int kNumMore = 90;
    scan.range_m.insert(scan.range_m.begin(), kNumMore, no_echo_m);
    scan.geometry.first_rad -= kNumMore * scan.geometry.step_rad;
    scan.geometry.num_beams += kNumMore;
    const Features shifted = detect(scan);
    expect_same(
        plain, shifted, [](const Eigen::Vector2d& p) { return p; }, false);
    for (std::size_t i = 0; i < plain.circles.size(); ++i) {
      EXPECT_EQ(shifted.circles[i].beams.first, plain.circles[i].beams.first + kNumMore);
    }
  }
}

// A person, a post and a plate around the sensor, in a square room with a corner opposite the person.
LaserScan turned_hall(double turn_rad, unsigned seed, int num_beams) {
  IdealScene scene({.num_beams = num_beams, .first_rad = turn_rad - kPi, .step_rad = kPi / 360});
  const auto at = [&](double bearing_rad, double range_m) { return polar(turn_rad + bearing_rad, range_m); };
  for (int i = 0; i < 4; ++i) scene.wall(at(i * kPi / 2, 7.0), at((i + 1) * kPi / 2, 7.0));
  scene.cylinder(at(0.05, 2.5), 0.06, Primitive::kLeg);
  scene.cylinder(at(-0.05, 2.4), 0.06, Primitive::kLeg);
  scene.cylinder(at(2.0, 1.8), 0.06);
  scene.wall(at(-2.03, 4.0), at(-1.97, 4.0));
  return with_noise(scene.scan(), 0.01, seed);
}

// An unrolled turn shows much of its surroundings twice; nothing may be lost, or be surer, by that. One beam
// less, and it is no turn.
TEST_P(ConformanceTest, AFullTurnShowsWhatATurnButForOneBeamShows) {
  std::size_t num_legs = 0;
  for (unsigned i = 0; i < 24; ++i) {
    const Features turn = detect(turned_hall(i * kPi / 12, i, 720));
    const Features almost = detect(turned_hall(i * kPi / 12, i, 719));
    EXPECT_EQ(turn.lines.size(), almost.lines.size());
    ASSERT_EQ(turn.circles.size(), almost.circles.size());
    ASSERT_EQ(turn.legs.size(), almost.legs.size());
    for (std::size_t k = 0; k < turn.legs.size(); ++k) {
      EXPECT_NEAR((turn.legs[k].middle_m - almost.legs[k].middle_m).norm(), 0.0, kSame_m);
      EXPECT_NEAR(turn.legs[k].score, almost.legs[k].score, kSame_m);
    }
    num_legs += turn.legs.size();
  }
  EXPECT_GE(num_legs, 40u);
}

// The same beams, and where the sensor has it the first one again behind the last.
TEST_P(ConformanceTest, AFullTurnIsTheSameWhereverItBegins) {
  const auto in_order_of_bearing = [](Features features) {
    const auto rising = [](const auto& p, const auto& q) {
      return std::atan2(p.y(), p.x()) < std::atan2(q.y(), q.x());
    };
    std::sort(features.lines.begin(), features.lines.end(),
              [&](const Line& a, const Line& b) { return rising(a.left_m, b.left_m); });
    std::sort(features.circles.begin(), features.circles.end(),
              [&](const Circle& a, const Circle& b) { return rising(a.center_m, b.center_m); });
    std::sort(features.legs.begin(), features.legs.end(),
              [&](const Leg& a, const Leg& b) { return rising(a.middle_m, b.middle_m); });
    return features;
  };
  for (const int num_repeated : {0, 1}) {
    const LaserScan scan = room(3, {.num_beams = 720, .first_rad = -kPi});
    const Features plain = in_order_of_bearing(detect(scan));
    ASSERT_GE(plain.lines.size(), 3u);
    ASSERT_GE(plain.circles.size(), 1u);
    for (int first = 0; first < 720; first += 7) {
      LaserScan other = scan;
      std::rotate(other.range_m.begin(), other.range_m.begin() + first, other.range_m.end());
      other.range_m.insert(other.range_m.end(), num_repeated, other.range_m.front());
      other.geometry.num_beams += num_repeated;
      other.geometry.first_rad = scan.geometry.bearing_rad(first);
      expect_same(
          plain, in_order_of_bearing(detect(other)), [](const Eigen::Vector2d& p) { return p; }, false);
    }
  }
}

TEST_P(ConformanceTest, FewBeamsAndEqualPointsGiveNothing) {
  for (const double range_m : {0.0, 1.0, kNoEcho, kTooClose, kInvalid, -1.0}) {
    for (const int num_beams : {0, 1, 2}) {
      LaserScan scan;
      scan.range_m.assign(num_beams, range_m);
      const Features features = detect(scan);
      EXPECT_TRUE(features.lines.empty() && features.circles.empty() && features.legs.empty());
    }
  }
  LaserScan one_point;
  one_point.geometry.step_rad = 0.0;
  one_point.range_m.assign(361, 2.0);
  const Features features = detect(one_point);
  EXPECT_TRUE(features.lines.empty() && features.circles.empty() && features.legs.empty());
}

TEST_P(ConformanceTest, TenThousandBeamsFindTheSameRoom) {
  ScanGeometry geometry;
  geometry.num_beams = 10'000;
  geometry.step_rad = kPi / 9'999;
  const Features features = detect(room(1, geometry));
  EXPECT_GE(features.circles.size(), 1u);
}

bool is_sound(const Features& features, int num_beams) {
  const auto spans = [&](const BeamSpan& beams) {
    return 0 <= beams.first && beams.first <= beams.last && beams.last < num_beams;
  };
  const auto is_score = [](double score) { return score >= 0.0 && score <= 1.0; };
  return std::all_of(features.lines.begin(), features.lines.end(),
                     [&](const Line& f) {
                       return spans(f.beams) && is_score(f.score) && f.left_m.allFinite() &&
                              f.right_m.allFinite();
                     }) &&
         std::all_of(features.circles.begin(), features.circles.end(),
                     [&](const Circle& f) {
                       return spans(f.beams) && is_score(f.score) && f.center_m.allFinite() &&
                              f.radius_m > 0.0;
                     }) &&
         std::all_of(features.legs.begin(), features.legs.end(), [&](const Leg& f) {
           return spans(f.beams) && is_score(f.score) && f.middle_m.allFinite();
         });
}

RC_GTEST_PROP(ConformancePropertyTest, AnyRangesGiveSoundFeatures, ()) {
  const auto words = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-5, 4000));
  LaserScan scan;
  for (const int word : words) {
    constexpr double kOdd[] = {kNoEcho, kTooClose, kInvalid, 0.0, -1.0};
    scan.range_m.push_back(word < 0 ? kOdd[word + 5] : word / 1000.0);
  }
  scan.geometry.step_rad = *rc::gen::element(kPi / 360, -kPi / 360, kPi / 7, 0.0, 1e-9);
  for (const std::string& preset : preset_names()) {
    RC_ASSERT(is_sound(FeatureDetector(*preset_options(preset)).detect(scan), scan.num_beams()));
  }
}

TEST_P(ConformanceTest, HugeAndTinyRangesGiveSoundFeatures) {
  for (const double range_m : {1e-300, 1e-9, 1e6, 1e150, std::numeric_limits<double>::max()}) {
    LaserScan scan;
    scan.range_m.assign(361, range_m);
    for (int i = 0; i < 361; i += 7) scan.range_m[i] = 2.0;
    EXPECT_TRUE(is_sound(detect(scan), 361)) << range_m;
  }
}

INSTANTIATE_TEST_SUITE_P(Presets, ConformanceTest, ::testing::ValuesIn(preset_names()),
                         [](const auto& preset) { return preset.param; });

}  // namespace
}  // namespace scanbed
