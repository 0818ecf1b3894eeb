// SPDX-License-Identifier: MIT
#include "bench/train_legs/leg_answers.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/geometry/angles.hpp"

namespace scanbed::bench {
namespace {

constexpr int kNothing = -1;

/// Beams half a degree apart that met, 2 m away, one object each, or nothing.
struct Seen {
  LaserScan scan;
  Truth truth;

  Seen(const std::vector<std::string>& ids, const std::vector<int>& objects) {
    scan.geometry = {.num_beams = static_cast<int>(objects.size()), .step_rad = radians(0.5)};
    for (const std::string& id : ids) {
      const bool is_leg = id.find("leg") != std::string::npos;
      truth.objects.push_back({.id = id, .label = is_leg ? "leg" : id});
    }
    for (const int object : objects) {
      scan.range_m.push_back(object == kNothing ? kNoEcho : 2.0);
      truth.beams.push_back({.object = object});
    }
  }

  // Of the candidate from the first beam to the last.
  LegAnswer answer(int first, int last) const {
    return answer_by_truth({.beams = {first, last}, .center_m = {2.0, 0.0}}, scan, truth);
  }
};

TEST(LegAnswersTest, ALegIsWhatCoversOneLegAndLittleElse) {
  const Seen seen({"leg1", "wall"}, {1, 1, 1, 0, 0, 0, 0, 1, 1, 1});
  EXPECT_EQ(seen.answer(3, 6), LegAnswer::kYes);
  EXPECT_EQ(seen.answer(3, 7), LegAnswer::kYes);      // 80 % of it is the leg
  EXPECT_EQ(seen.answer(2, 7), LegAnswer::kUnknown);  // 67 %
  EXPECT_EQ(seen.answer(3, 4), LegAnswer::kUnknown);  // half of the leg
  EXPECT_EQ(seen.answer(0, 3), LegAnswer::kNo);       // 25 %, and a quarter of the leg
  EXPECT_EQ(seen.answer(7, 9), LegAnswer::kNo);
}

TEST(LegAnswersTest, EdgesOfOneOutlineAreOneLeg) {
  const Seen seen({"leg7.0", "leg7.1"}, {kNothing, 0, 0, 1, 1, kNothing});
  EXPECT_EQ(seen.answer(1, 4), LegAnswer::kYes);
}

TEST(LegAnswersTest, TwoLegsTogetherAreNeither) {
  const Seen seen({"a.left_leg", "a.right_leg"}, {kNothing, 0, 0, 0, 1, 1, 1, kNothing});
  EXPECT_EQ(seen.answer(1, 3), LegAnswer::kYes);
  EXPECT_EQ(seen.answer(4, 6), LegAnswer::kYes);
  EXPECT_EQ(seen.answer(1, 6), LegAnswer::kUnknown);
}

// A leg 0.10 m wide would have five beams there.
TEST(LegAnswersTest, ALegThatIsNearlyHiddenIsNone) {
  const Seen seen({"leg1", "wall"}, {1, 0, 0, 1});
  EXPECT_EQ(seen.answer(1, 2), LegAnswer::kNo);
}

TEST(LegAnswersTest, APostOfALegsSizeIsNeither) {
  Seen seen({"post"}, {0, 0, 0, 0});
  seen.truth.objects[0].primitive = Primitive::kCircle;
  seen.truth.objects[0].radius_m = 0.06;
  EXPECT_EQ(seen.answer(0, 3), LegAnswer::kUnknown);
  seen.truth.objects[0].radius_m = 0.3;
  EXPECT_EQ(seen.answer(0, 3), LegAnswer::kNo);
}

TEST(LegAnswersTest, LabelsAnswerInTheirSectorOnly) {
  const std::vector<Eigen::Vector2d> labels{{2.0, 0.0}};
  const auto at = [&](double x_m, double y_m) { return answer_by_labels({.center_m = {x_m, y_m}}, labels); };
  EXPECT_EQ(at(2.05, 0.08), LegAnswer::kYes);
  EXPECT_EQ(at(2.0, 0.2), LegAnswer::kUnknown);
  EXPECT_EQ(at(2.0, 0.31), LegAnswer::kNo);
  EXPECT_EQ(at(2.0, 1.0), LegAnswer::kUnknown);  // 27 degrees aside
  EXPECT_EQ(at(5.5, 0.0), LegAnswer::kUnknown);
}

}  // namespace
}  // namespace scanbed::bench
