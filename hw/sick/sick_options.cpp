// SPDX-License-Identifier: MIT
#include "hw/sick/sick_options.hpp"

#include "core/errors/input_error.hpp"

namespace scanbed::hw {

void SickOptions::validate() const {
  if (path.empty()) throw InputError("sick: no port; write sick:/dev/serial/by-id/...");
  require(is_lms_baud(baud), "sick.baud", baud, kLmsBaudNames);
  require(fov_deg == 180 || fov_deg == 100, "sick.fov_deg", fov_deg, "180, 100");
  require(resolution_cdeg == 100 || resolution_cdeg == 50 || resolution_cdeg == 25, "sick.resolution_deg",
          resolution_cdeg / 100.0, "1, 0.5, 0.25");
  require(!measuring_mode || lms_word_format(*measuring_mode).has_value(), "sick.mode",
          measuring_mode.value_or(0), "0 to 6, 15");
  require(max_waiting >= 1, "sick.max_waiting", max_waiting, ">= 1");
  require(patience.ack_s > 0.0, "sick.ack_s", patience.ack_s, "> 0");
  require(patience.num_first_attempts >= 1, "sick.num_first_attempts", patience.num_first_attempts, ">= 1");
}

ScanGeometry sick_geometry(const SickOptions& options, const LmsWordFormat& format) {
  const LmsVariant variant = options.variant();
  ScanGeometry geometry;
  geometry.num_beams = variant.num_beams();
  geometry.first_rad = -0.5 * radians(variant.fov_deg);
  geometry.step_rad = radians(variant.resolution_cdeg / 100.0);
  geometry.max_range_m = lms_max_range_m(options.unit, format.range_bits);
  geometry.timing.num_rotations = variant.num_rotations();
  geometry.timing.rotation_s = kLmsRotation_s;
  geometry.timing.step_s = kLmsRotation_s / 360.0;
  return geometry;
}

}  // namespace scanbed::hw
