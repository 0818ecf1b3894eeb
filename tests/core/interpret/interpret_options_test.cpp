// SPDX-License-Identifier: MIT
#include "core/interpret/interpret_options.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "core/errors/input_error.hpp"

namespace scanbed {
namespace {

TEST(InterpretOptionsTest, DefaultsValidate) {
  EXPECT_NO_THROW(InterpretOptions{}.validate());
}

TEST(InterpretOptionsTest, EachBadFieldIsNamed) {
  const std::vector<std::pair<std::string, std::function<void(InterpretOptions&)>>> faults = {
      {"interpret.min_wall_m", [](InterpretOptions& o) { o.min_wall_m = -1.0; }},
      {"interpret.wall_offset_m", [](InterpretOptions& o) { o.wall_offset_m = 0.0; }},
      {"interpret.max_wall_gap_m", [](InterpretOptions& o) { o.max_wall_gap_m = -1.0; }},
      {"interpret.min_corner_rad", [](InterpretOptions& o) { o.min_corner_rad = 2.0; }},
      {"interpret.corner_reach_m", [](InterpretOptions& o) { o.corner_reach_m = 0.0; }},
      {"interpret.min_door_m", [](InterpretOptions& o) { o.min_door_m = 0.0; }},
      {"interpret.max_door_m", [](InterpretOptions& o) { o.max_door_m = 0.5; }},
      {"interpret.bench_gap_m", [](InterpretOptions& o) { o.bench_gap_m = 0.0; }},
      {"interpret.bench_tolerance_m", [](InterpretOptions& o) { o.bench_tolerance_m = 0.0; }},
      {"interpret.max_bench_radius_m", [](InterpretOptions& o) { o.max_bench_radius_m = 0.0; }},
      {"interpret.min_trash_can_radius_m", [](InterpretOptions& o) { o.min_trash_can_radius_m = -0.1; }},
      {"interpret.max_trash_can_radius_m", [](InterpretOptions& o) { o.max_trash_can_radius_m = 0.1; }},
  };
  for (const auto& [name, spoil] : faults) {
    InterpretOptions options;
    spoil(options);
    try {
      options.validate();
      FAIL() << name << " was accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(name + ":", 0), 0u) << error.what();
    }
  }
}

}  // namespace
}  // namespace scanbed
