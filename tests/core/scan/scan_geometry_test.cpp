// SPDX-License-Identifier: MIT
#include "core/scan/scan_geometry.hpp"

#include <gtest/gtest.h>

#include "core/errors/input_error.hpp"

namespace scanbed {
namespace {

TEST(ScanGeometryTest, RefusesWhatNoSensorHas) {
  const auto check = [](const ScanGeometry& geometry) { check_geometry(geometry); };
  EXPECT_NO_THROW(check({}));
  EXPECT_THROW(check({.num_beams = 2, .step_rad = 0.0}), InputError);
  EXPECT_THROW(check({.num_beams = 1000, .step_rad = 0.1}), InputError);
  EXPECT_THROW(check({.first_rad = 10.0}), InputError);
  EXPECT_THROW(check({.first_rad = std::nan("")}), InputError);
  EXPECT_THROW(check({.step_rad = std::nan("")}), InputError);
  EXPECT_THROW(check({.max_range_m = std::nan("")}), InputError);
  EXPECT_THROW(check({.timing = {.num_rotations = 0}}), InputError);
  EXPECT_NO_THROW(check({.num_beams = 1, .step_rad = 0.0}));
}

TEST(ScanGeometryTest, SaysWhatIsWrong) {
  EXPECT_EQ(fault_of({}), "");
  EXPECT_EQ(fault_of({.num_beams = 2, .step_rad = 0.0}), "all beams point the same way");
}

}  // namespace
}  // namespace scanbed
