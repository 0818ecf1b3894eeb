// SPDX-License-Identifier: MIT
#include "core/text/number_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace scanbed {
namespace {

TEST(NumberTextTest, ShowsANumberAsItWasWritten) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(8.182), "8.182");
  EXPECT_EQ(number_text(-5000000.0), "-5000000");
  EXPECT_EQ(number_text(1.0 / 3.0), "0.333333333333333");
  EXPECT_EQ(number_text(1e-9), "1e-09");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "inf");
}

}  // namespace
}  // namespace scanbed
