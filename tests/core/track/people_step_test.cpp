// SPDX-License-Identifier: MIT
#include "core/track/people_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "core/geometry/angles.hpp"
#include "core/geometry/polar.hpp"
#include "tests/core/track/made_features.hpp"

namespace scanbed {
namespace {

using testing::leg_at;
using testing::open_scan;

constexpr double kAnyLoss = 1e9;

/// One hypothesis, which always takes the best answer.
class Story {
 public:
  std::vector<LegClaims::Answer> look(const std::vector<Leg>& legs) {
    scan_ = open_scan(time_s_);
    legs_ = legs;
    step_.begin(now_, legs_, options_);
    step_.predict(hypothesis);
    step_.claim(hypothesis, claims_);
    time_s_ += now_.dt_s;
    const std::span<const LegClaims::Answer> answers = claims_.solve(100, kAnyLoss);
    return {answers.begin(), answers.end()};
  }

  void show(const std::vector<Leg>& legs) {
    const LegClaims::Answer best = look(legs).front();
    std::vector<LegClaim> claim_of_track;
    for (std::size_t i = 0; i < hypothesis.tracks.size(); ++i)
      claim_of_track.push_back(claims_.claim_of(best, static_cast<int>(i)));
    step_.explain(hypothesis, claim_of_track);
  }

  LegClaim claim(const LegClaims::Answer& answer, int track) const { return claims_.claim_of(answer, track); }

  PeopleHypothesis hypothesis;

 private:
  double time_s_ = 0.0;
  LaserScan scan_ = open_scan(0.0);
  TrackedScan now_{scan_, {}, 0.1};
  std::vector<Leg> legs_;
  TrackOptions options_;
  PeopleStep step_;
  LegClaims claims_;
};

TEST(PeopleStepTest, TwoLegsThatKeepCloseAreOnePerson) {
  Story story;
  story.show({leg_at({2.0, 0.1}), leg_at({2.0, -0.1})});
  ASSERT_EQ(story.hypothesis.tracks.size(), 1u);
  EXPECT_TRUE(story.hypothesis.tracks[0].is_person());
  EXPECT_EQ(story.hypothesis.tracks[0].num_legs_seen, 2);
}

// Of n legs around a person each two may be theirs: of 30 there would be 465 answers.
TEST(PeopleStepTest, APersonClaimsTheNearestLegsOfMany) {
  Story story;
  for (int i = 0; i < 5; ++i) story.show({leg_at({2.0, 0.1}), leg_at({2.0, -0.1})});
  std::vector<Leg> legs;
  for (int i = 0; i < 28; ++i)
    legs.push_back(leg_at(Eigen::Vector2d(2.0, 0.0) + polar(2.0 * kPi * i / 28, 0.3)));
  legs.push_back(leg_at({2.0, 0.1}));
  legs.push_back(leg_at({2.0, -0.1}));
  const std::vector<LegClaims::Answer> answers = story.look(legs);
  const LegClaim best = story.claim(answers.front(), 0);
  EXPECT_EQ(std::minmax({best.first, best.second}), std::minmax({28, 29}));
  EXPECT_LE(answers.size(), 1u + 12u + 12u * 11u / 2u);  // nobody, one of 12, two of 12
}

TEST(PeopleStepTest, EachTrackHasABirthOfItsOwn) {
  Story story;
  story.show({leg_at({2.0, 0.0}), leg_at({2.0, 2.0})});
  story.show({leg_at({2.0, 0.0}), leg_at({2.0, 2.0}), leg_at({2.0, -2.0})});
  const std::vector<LiveTrack>& tracks = story.hypothesis.tracks;
  ASSERT_EQ(tracks.size(), 3u);
  EXPECT_NE(tracks[0].birth, tracks[1].birth);
  EXPECT_NE(tracks[1].birth, tracks[2].birth);
  EXPECT_NE(tracks[0].birth, tracks[2].birth);
}

// Legs are 0.2 m apart. Of the three, two are parts of the first one: the less sure part is left to nobody.
TEST(PeopleStepTest, APartOfALegIsNoLeg) {
  Story story;
  for (int i = 0; i < 20; ++i) story.show({leg_at({2.0, 0.1}), leg_at({2.0, -0.1})});
  story.show({leg_at({2.0, 0.13}, 0.9), leg_at({2.0, 0.06}, 0.4), leg_at({2.0, -0.1}, 0.9)});
  const LiveTrack& person = story.hypothesis.tracks[0];
  EXPECT_EQ(person.feature, 0);
  EXPECT_EQ(person.second_feature, 2);
}

// A leg alone gains what it would cost unexplained, less how surprising it is; a part of another leg, surer
// and nearer than 0.13 m, costs 4 in place of 12.
TEST(PeopleStepTest, APartOfALegCostsLittleUnexplained) {
  const auto gain_of_leg = [](double apart_m, double other_score) {
    Story story;
    for (int i = 0; i < 20; ++i) story.show({leg_at({2.0, 0.0}, 0.4)});
    const std::vector<Leg> legs = {leg_at({2.0, 0.0}, 0.4), leg_at({2.0, apart_m}, other_score)};
    double gain = 0.0;  // of the first leg for the track
    for (const LegClaims::Answer& answer : story.look(legs)) {
      if (story.claim(answer, 0).first == 0) gain = answer.gain;
    }
    return gain;
  };
  const double gain = gain_of_leg(1.0, 0.9);
  EXPECT_GT(gain, 8.0);
  EXPECT_NEAR(gain_of_leg(0.14, 0.9), gain, 1e-9);
  EXPECT_NEAR(gain_of_leg(0.12, 0.9), gain - 8.0, 1e-9);
  EXPECT_NEAR(gain_of_leg(0.12, 0.3), gain, 1e-9);  // the other one is the part
}

// At 2 m beams are 2 m times their step apart. Two beams more than the mean are 2 spacings off, of 0.02 m and
// one spacing; two fewer are a third of that.
TEST(PeopleStepTest, AWidthThatIsNotTheOwnIsASurprise) {
  const auto leg_of = [](int num_beams) {
    Leg leg = leg_at({2.0, 0.0});
    leg.beams = {100, 100 + num_beams - 1};
    return leg;
  };
  Story story;
  for (int i = 0; i < 20; ++i) story.show({leg_of(6)});
  const double own = story.look({leg_of(6)}).front().gain;
  Story of_wide;
  for (int i = 0; i < 20; ++i) of_wide.show({leg_of(6)});
  const double wide = of_wide.look({leg_of(8)}).front().gain;
  Story of_narrow;
  for (int i = 0; i < 20; ++i) of_narrow.show({leg_of(6)});
  const double narrow = of_narrow.look({leg_of(4)}).front().gain;
  const double spacing_m = 2.0 * ScanGeometry{}.step_rad;
  const double off = 2.0 * spacing_m / (0.02 + spacing_m);
  EXPECT_NEAR(own - wide, off * off, 1e-9);
  EXPECT_NEAR(own - narrow, off * off / 9.0, 1e-9);
}

TEST(PeopleStepTest, NoPairIsWiderThanAStep) {
  for (const auto& [apart_m, is_pair] : {std::pair{0.75, true}, {0.85, false}}) {
    Story story;
    for (int i = 0; i < 20; ++i) story.show({leg_at({2.0, 0.1}), leg_at({2.0, -0.1})});
    const std::vector<LegClaims::Answer> answers =
        story.look({leg_at({2.0, apart_m / 2}), leg_at({2.0, -apart_m / 2})});
    const bool has_pair = std::any_of(answers.begin(), answers.end(), [&](const LegClaims::Answer& answer) {
      return story.claim(answer, 0).second != kNoLeg;
    });
    EXPECT_EQ(has_pair, is_pair) << apart_m;
  }
}

}  // namespace
}  // namespace scanbed
