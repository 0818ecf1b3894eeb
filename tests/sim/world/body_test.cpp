// SPDX-License-Identifier: MIT
#include "sim/world/body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace scanbed::sim {
namespace {

// ANSUR II: calf 125 / 119 mm, ankle 73 / 69 mm, tibial height 468 / 438 mm.
TEST(BodyTest, MeanBodiesHaveThePublishedShins) {
  const Body man = mean_body(Person::kMan);
  EXPECT_NEAR(2.0 * man.leg_radius_m(0.7 * 0.468), 0.125, 1e-12);
  EXPECT_NEAR(2.0 * man.leg_radius_m(0.05), 0.073, 1e-12);
  const Body woman = mean_body(Person::kWoman);
  EXPECT_NEAR(2.0 * woman.leg_radius_m(0.7 * 0.438), 0.119, 1e-12);
  EXPECT_NEAR(2.0 * woman.leg_radius_m(0.0), 0.069, 1e-12);
}

TEST(BodyTest, AShinIsThickestAtTheCalf) {
  const Body man = mean_body(Person::kMan);
  const double calf_m = 0.7 * man.knee_m;
  for (double h = 0.0; h < 1.0; h += 0.01) {
    EXPECT_LE(man.leg_radius_m(h), man.leg_radius_m(calf_m));
    EXPECT_GE(man.leg_radius_m(h), man.leg_radius_m(0.0));
    EXPECT_NEAR(man.leg_radius_m(h), man.leg_radius_m(h + 1e-6), 1e-6);  // no step
  }
}

TEST(BodyTest, ChildrenAreSmall) {
  const Body child = mean_body(Person::kChild);
  EXPECT_NEAR(child.stature_m, 0.7 * 1.629, 1e-12);
  EXPECT_LT(child.leg_radius_m(0.28), mean_body(Person::kWoman).leg_radius_m(0.28));
}

// Means and spreads of 4000 men; 4.5 standard errors. Cutting off at 2.5 sigma takes 9 % from the variance:
// 1 - 2 x 2.5 phi(2.5) / (2 Phi(2.5) - 1) plus what stays at the ends, 2 x 2.5^2 (1 - Phi(2.5)).
TEST(BodyTest, DrawnBodiesHaveThePublishedMeansAndSpreads) {
  constexpr int kNum = 4000;
  double sum = 0.0;
  double sum_sq = 0.0;
  for (int i = 0; i < kNum; ++i) {
    const double calf_m = draw_body(Person::kMan, 7, "walker" + std::to_string(i)).calf_diameter_m;
    EXPECT_GE(calf_m, 0.125 - 2.5 * 0.0096);
    EXPECT_LE(calf_m, 0.125 + 2.5 * 0.0096);
    sum += calf_m - 0.125;
    sum_sq += (calf_m - 0.125) * (calf_m - 0.125);
  }
  EXPECT_NEAR(sum / kNum, 0.0, 4.5 * 0.0095 / std::sqrt(1.0 * kNum));
  EXPECT_NEAR(std::sqrt(sum_sq / kNum), 0.0095, 0.0095 * (4.5 * std::sqrt(0.5 / kNum) + 0.04));
}

TEST(BodyTest, TheSameSeedAndIdGiveTheSameBody) {
  EXPECT_EQ(draw_body(Person::kWoman, 1, "anna").stature_m, draw_body(Person::kWoman, 1, "anna").stature_m);
  EXPECT_NE(draw_body(Person::kWoman, 1, "anna").stature_m, draw_body(Person::kWoman, 2, "anna").stature_m);
  EXPECT_NE(draw_body(Person::kWoman, 1, "anna").stature_m, draw_body(Person::kWoman, 1, "berta").stature_m);
}

TEST(BodyTest, ClothesMakeLegsWiderAndRougher) {
  Walker bare, trousers, skirt;
  give_body(bare, mean_body(Person::kWoman), Clothing::kBare, 0.28);
  give_body(trousers, mean_body(Person::kWoman), Clothing::kTrousers, 0.28);
  give_body(skirt, mean_body(Person::kWoman), Clothing::kSkirt, 0.28);
  EXPECT_LT(bare.leg_radius_m, trousers.leg_radius_m);
  EXPECT_LT(trousers.leg_radius_m, skirt.leg_radius_m);
  EXPECT_EQ(bare.material.roughness_m, 0.0);
  EXPECT_LT(trousers.material.roughness_m, skirt.material.roughness_m);
  EXPECT_EQ(bare.height_m, 1.629);
}

TEST(BodyTest, EveryDrawnWalkerIsOneThatAWorldAccepts) {
  for (const Person person : {Person::kWoman, Person::kMan, Person::kChild}) {
    for (int i = 0; i < 50; ++i) {
      World world;
      world.walkers.push_back({.id = "w" + std::to_string(i), .path = {.points_m = {{3, 0}, {5, 0}}}});
      give_body(world.walkers[0], draw_body(person, 3, world.walkers[0].id), Clothing::kSkirt, 0.28);
      EXPECT_NO_THROW(world.validate());
      EXPECT_GE(world.walkers[0].speed_m_per_s, 0.9);
      EXPECT_LE(world.walkers[0].speed_m_per_s, 1.5);
    }
  }
}

}  // namespace
}  // namespace scanbed::sim
