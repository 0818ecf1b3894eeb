// SPDX-License-Identifier: MIT
#include "core/detect/robust/surface_options.hpp"

#include "core/errors/input_error.hpp"

namespace scanbed {
namespace {

void require_price(double price, const char* name) {
  require(price >= 0.0 && price <= 1000.0, name, price, "[0, 1000]");
}

void validate_gaps(const SurfaceOptions& o) {
  require(o.min_gap_m > 0.0 && o.min_gap_m <= 10.0, "surface.min_gap_m", o.min_gap_m, "(0, 10]");
  require(o.gap_spacings >= 0.0 && o.gap_spacings <= 100.0, "surface.gap_spacings", o.gap_spacings,
          "[0, 100]");
  require(o.max_grazing_step_m >= 0.0 && o.max_grazing_step_m <= 10.0, "surface.max_grazing_step_m",
          o.max_grazing_step_m, "[0, 10]");
  require(o.max_speck_beams >= 0 && o.max_speck_beams <= 1000, "surface.max_speck_beams", o.max_speck_beams,
          "[0, 1000]");
}

void validate_noise(const SurfaceOptions& o) {
  require(o.min_noise_m >= 1e-4 && o.min_noise_m <= 1.0, "surface.min_noise_m", o.min_noise_m, "[0.0001, 1]");
  require(o.max_noise_m >= o.min_noise_m && o.max_noise_m <= 1.0, "surface.max_noise_m", o.max_noise_m,
          "[min_noise_m, 1]");
  require(o.noise_ratio >= 0.0 && o.noise_ratio <= 0.2, "surface.noise_ratio", o.noise_ratio, "[0, 0.2]");
  require(o.noise_inflation >= 0.1 && o.noise_inflation <= 10.0, "surface.noise_inflation", o.noise_inflation,
          "[0.1, 10]");
}

void validate_prices(const SurfaceOptions& o) {
  require_price(o.line_price, "surface.line_price");
  require_price(o.arc_price, "surface.arc_price");
  require_price(o.clutter_price, "surface.clutter_price");
  require_price(o.hidden_end_price, "surface.hidden_end_price");
  require_price(o.attached_end_price, "surface.attached_end_price");
  require_price(o.unsure_arc_price, "surface.unsure_arc_price");
  require_price(o.shallow_arc_price, "surface.shallow_arc_price");
  require(o.shallow_arc_rad >= 0.0 && o.shallow_arc_rad <= kPi, "surface.shallow_arc_rad", o.shallow_arc_rad,
          "[0, 3.1416]");
  require(o.doubt_ratio >= 0.0 && o.doubt_ratio <= 1.0, "surface.doubt_ratio", o.doubt_ratio, "[0, 1]");
  require_price(o.doubt_start, "surface.doubt_start");
  require_price(o.max_doubt, "surface.max_doubt");
  require(o.max_chi2_per_point > 0.0 && o.max_chi2_per_point <= 1000.0, "surface.max_chi2_per_point",
          o.max_chi2_per_point, "(0, 1000]");
  require(o.max_direction_sigma_rad > 0.0 && o.max_direction_sigma_rad <= kPi,
          "surface.max_direction_sigma_rad", o.max_direction_sigma_rad, "(0, 3.1416]");
}

}  // namespace

void SurfaceOptions::validate() const {
  validate_gaps(*this);
  validate_noise(*this);
  validate_prices(*this);
  require(min_radius_m >= 0.02 && min_radius_m <= 10.0, "surface.min_radius_m", min_radius_m, "[0.02, 10]");
  require(max_radius_m > min_radius_m && max_radius_m <= 10.0, "surface.max_radius_m", max_radius_m,
          "(min_radius_m, 10]");
}

}  // namespace scanbed
