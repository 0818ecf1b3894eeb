// SPDX-License-Identifier: MIT
#include "hw/recording/even_angles.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace scanbed::hw {
namespace {

ScanGeometry restored(double first_rad, double step_rad, const AngleRounding& rounding) {
  ScanGeometry geometry;
  geometry.first_rad = first_rad;
  geometry.step_rad = step_rad;
  restore_even_angles(geometry, rounding);
  return geometry;
}

ScanGeometry restored_float(double first_rad, double step_rad) {
  const auto first = static_cast<double>(static_cast<float>(first_rad));
  const auto step = static_cast<double>(static_cast<float>(step_rad));
  return restored(first, step, {std::abs(first) * 0x1p-23, std::abs(step) * 0x1p-23});
}

TEST(EvenAnglesTest, TheAnglesOfKnownSensorsSurviveFloats) {
  const ScanGeometry lms = restored_float(-kPi / 2, kPi / 360);
  EXPECT_EQ(lms.first_rad, -kPi / 2);
  EXPECT_EQ(lms.step_rad, kPi / 360);
  const ScanGeometry hokuyo = restored_float(-3 * kPi / 4, 2 * kPi / 1024);
  EXPECT_EQ(hokuyo.first_rad, -3 * kPi / 4);
  EXPECT_EQ(hokuyo.step_rad, 2 * kPi / 1024);
  EXPECT_EQ(restored_float(kPi / 2, -kPi / 180).step_rad, -kPi / 180);
}

TEST(EvenAnglesTest, FourDigitsAreEnoughForTheFirstAngle) {
  const ScanGeometry lms = restored(-1.5708, 0.00872665, {0.6e-4, 0.6e-8});
  EXPECT_EQ(lms.first_rad, -kPi / 2);
  EXPECT_EQ(lms.step_rad, kPi / 360);
}

TEST(EvenAnglesTest, OtherAnglesStayAsTheyAre) {
  const ScanGeometry odd = restored_float(-1.1, 0.01);
  EXPECT_EQ(odd.first_rad, static_cast<double>(-1.1F));
  EXPECT_EQ(odd.step_rad, static_cast<double>(0.01F));
  for (const double bad : {0.0, std::nan(""), HUGE_VAL, 1e300}) {
    const ScanGeometry kept = restored(-1.0, bad, {});
    EXPECT_TRUE(kept.step_rad == bad || std::isnan(bad));
    const ScanGeometry first = restored(bad, kPi / 360, {1e-9, 1e-9});
    EXPECT_TRUE(first.first_rad == bad || std::isnan(bad));
  }
}

TEST(EvenAnglesTest, DecimalsComeBackFromFloats) {
  EXPECT_EQ(shortest_decimal(8.182F), 8.182);
  EXPECT_EQ(shortest_decimal(0.1F), 0.1);
  EXPECT_EQ(shortest_decimal(-3.0F), -3.0);
  EXPECT_TRUE(std::isnan(shortest_decimal(std::nanf(""))));
  EXPECT_EQ(shortest_decimal(HUGE_VALF), HUGE_VAL);
  // All that an LMS can say, in millimetres and centimetres.
  for (int steps = 0; steps <= 8182; ++steps) {
    ASSERT_EQ(shortest_decimal(static_cast<float>(steps / 1000.0)), steps / 1000.0);
    ASSERT_EQ(shortest_decimal(static_cast<float>(steps / 100.0)), steps / 100.0);
  }
}

RC_GTEST_PROP(EvenAnglesTest, TheDecimalRoundsToTheSameFloat, (float value)) {
  RC_PRE(std::isfinite(value));
  RC_ASSERT(static_cast<float>(shortest_decimal(value)) == value);
}

}  // namespace
}  // namespace scanbed::hw
