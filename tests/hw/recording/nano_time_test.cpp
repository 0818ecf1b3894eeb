// SPDX-License-Identifier: MIT
#include "hw/recording/nano_time.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/errors/input_error.hpp"

namespace scanbed::hw {
namespace {

TEST(NanoTimeTest, SplitsSecondsAndCarries) {
  EXPECT_EQ(to_nano_time(0.0).sec, 0U);
  EXPECT_EQ(to_nano_time(1.25).sec, 1U);
  EXPECT_EQ(to_nano_time(1.25).nsec, 250'000'000U);
  const NanoTime carried = to_nano_time(std::nextafter(2.0, 1.0));
  EXPECT_EQ(carried.sec, 2U);
  EXPECT_EQ(carried.nsec, 0U);
}

TEST(NanoTimeTest, RefusesTimesWithoutPlace) {
  for (const double time_s : {-1e-9, -1.0, 4294967296.0, 1e300, HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    EXPECT_THROW(to_nano_time(time_s), InputError) << time_s;
  }
}

RC_GTEST_PROP(NanoTimeTest, KeepsATimeToHalfANanosecond, (std::uint32_t sec, std::uint32_t part)) {
  const double time_s = static_cast<double>(sec % 4'000'000'000U) + part * 0x1p-32;
  // Half a nanosecond, or half a unit in the last place of such a double where that is coarser.
  const double unit_s = std::nextafter(time_s, HUGE_VAL) - time_s;
  RC_ASSERT(std::abs(to_seconds(to_nano_time(time_s)) - time_s) <= 0.501e-9 + unit_s / 2);
  // Where doubles are coarser than that, the very time comes back.
  if (unit_s > 2e-9) RC_ASSERT(to_seconds(to_nano_time(time_s)) == time_s);
}

}  // namespace
}  // namespace scanbed::hw
