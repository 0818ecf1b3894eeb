// SPDX-License-Identifier: MIT
#include "core/score/match_options.hpp"

#include <gtest/gtest.h>

#include <string>

#include "core/errors/input_error.hpp"

namespace scanbed {
namespace {

TEST(MatchOptionsTest, DefaultsValidate) {
  EXPECT_NO_THROW(MatchOptions{}.validate());
}

TEST(MatchOptionsTest, EachFieldOutOfRangeIsNamed) {
  const std::pair<const char*, MatchOptions> cases[] = {
      {"match.line_angle_rad", {.line_angle_rad = 0.0}},
      {"match.line_offset_m", {.line_offset_m = -1.0}},
      {"match.line_overlap_ratio", {.line_overlap_ratio = 1.1}},
      {"match.circle_center_m", {.circle_center_m = 0.0}},
      {"match.circle_radius_m", {.circle_radius_m = 11.0}},
      {"match.leg_center_m", {.leg_center_m = 0.0}},
      {"match.narrow_cylinder_m", {.narrow_cylinder_m = -0.1}},
      {"match.person_m", {.person_m = 0.0}},
      {"match.cylinder_m", {.cylinder_m = -1.0}}};
  for (const auto& [name, options] : cases) {
    try {
      options.validate();
      ADD_FAILURE() << name << " was accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(name, 0), 0u) << error.what();
    }
  }
}

}  // namespace
}  // namespace scanbed
