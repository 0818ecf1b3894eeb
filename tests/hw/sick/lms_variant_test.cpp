// SPDX-License-Identifier: MIT
#include "hw/sick/lms_variant.hpp"

#include <gtest/gtest.h>

namespace scanbed::hw {
namespace {

TEST(LmsVariantTest, HasTheBeamsOfTheDataSheet) {
  EXPECT_EQ((LmsVariant{180, 100}).num_beams(), 181);
  EXPECT_EQ((LmsVariant{180, 50}).num_beams(), 361);
  EXPECT_EQ((LmsVariant{100, 100}).num_beams(), 101);
  EXPECT_EQ((LmsVariant{100, 50}).num_beams(), 201);
  EXPECT_EQ((LmsVariant{100, 25}).num_beams(), 401);
}

TEST(LmsVariantTest, FinerScansInterlaceTurns) {
  EXPECT_EQ((LmsVariant{180, 100}).num_rotations(), 1);
  EXPECT_EQ((LmsVariant{180, 50}).num_rotations(), 2);
  EXPECT_EQ((LmsVariant{100, 25}).num_rotations(), 4);
}

TEST(LmsVariantTest, AQuarterDegreeIsNotOfferedAt180) {
  EXPECT_FALSE((LmsVariant{180, 25}).is_offered());
  EXPECT_TRUE((LmsVariant{100, 25}).is_offered());
  EXPECT_TRUE((LmsVariant{180, 50}).is_offered());
  EXPECT_FALSE((LmsVariant{90, 50}).is_offered());
  EXPECT_FALSE((LmsVariant{180, 30}).is_offered());
}

TEST(LmsVariantTest, KnowsItsBauds) {
  for (const int baud : {9600, 19200, 38400, 500000}) EXPECT_TRUE(is_lms_baud(baud));
  EXPECT_FALSE(is_lms_baud(115200));
}

}  // namespace
}  // namespace scanbed::hw
