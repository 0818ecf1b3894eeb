// SPDX-License-Identifier: MIT
#include "core/detect/robust/surface_options.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "core/errors/input_error.hpp"

namespace scanbed {
namespace {

TEST(SurfaceOptionsTest, DefaultsValidate) {
  EXPECT_NO_THROW(SurfaceOptions{}.validate());
}

TEST(SurfaceOptionsTest, EachBadFieldIsNamed) {
  using Spoil = std::function<void(SurfaceOptions&)>;
  const std::vector<std::pair<std::string, Spoil>> faults = {
      {"surface.min_gap_m", [](SurfaceOptions& o) { o.min_gap_m = 0.0; }},
      {"surface.gap_spacings", [](SurfaceOptions& o) { o.gap_spacings = -1.0; }},
      {"surface.max_grazing_step_m", [](SurfaceOptions& o) { o.max_grazing_step_m = -1.0; }},
      {"surface.max_speck_beams", [](SurfaceOptions& o) { o.max_speck_beams = -1; }},
      {"surface.min_noise_m", [](SurfaceOptions& o) { o.min_noise_m = 0.0; }},
      {"surface.max_noise_m", [](SurfaceOptions& o) { o.max_noise_m = 0.001; }},
      {"surface.noise_ratio", [](SurfaceOptions& o) { o.noise_ratio = -0.01; }},
      {"surface.noise_inflation", [](SurfaceOptions& o) { o.noise_inflation = 0.0; }},
      {"surface.line_price", [](SurfaceOptions& o) { o.line_price = -1.0; }},
      {"surface.arc_price", [](SurfaceOptions& o) { o.arc_price = -1.0; }},
      {"surface.clutter_price", [](SurfaceOptions& o) { o.clutter_price = -1.0; }},
      {"surface.hidden_end_price", [](SurfaceOptions& o) { o.hidden_end_price = -1.0; }},
      {"surface.attached_end_price", [](SurfaceOptions& o) { o.attached_end_price = -1.0; }},
      {"surface.unsure_arc_price", [](SurfaceOptions& o) { o.unsure_arc_price = -1.0; }},
      {"surface.shallow_arc_price", [](SurfaceOptions& o) { o.shallow_arc_price = -1.0; }},
      {"surface.shallow_arc_rad", [](SurfaceOptions& o) { o.shallow_arc_rad = 4.0; }},
      {"surface.doubt_ratio", [](SurfaceOptions& o) { o.doubt_ratio = 1.5; }},
      {"surface.doubt_start", [](SurfaceOptions& o) { o.doubt_start = -1.0; }},
      {"surface.max_doubt", [](SurfaceOptions& o) { o.max_doubt = 2000.0; }},
      {"surface.max_chi2_per_point", [](SurfaceOptions& o) { o.max_chi2_per_point = 0.0; }},
      {"surface.max_direction_sigma_rad", [](SurfaceOptions& o) { o.max_direction_sigma_rad = 0.0; }},
      {"surface.min_radius_m", [](SurfaceOptions& o) { o.min_radius_m = 0.0; }},
      {"surface.max_radius_m", [](SurfaceOptions& o) { o.max_radius_m = 0.01; }},
  };
  for (const auto& [name, spoil] : faults) {
    SurfaceOptions options;
    spoil(options);
    try {
      options.validate();
      FAIL() << name << " was accepted";
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(name + ":")) << error.what();
    }
  }
}

}  // namespace
}  // namespace scanbed
