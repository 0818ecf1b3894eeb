// SPDX-License-Identifier: MIT
#include "hw/sick/lms_variant.hpp"

#include <algorithm>

namespace scanbed::hw {

bool LmsVariant::is_offered() const {
  if (fov_deg == 180) return resolution_cdeg == 100 || resolution_cdeg == 50;
  return fov_deg == 100 && (resolution_cdeg == 100 || resolution_cdeg == 50 || resolution_cdeg == 25);
}

bool is_lms_baud(std::int64_t baud) {
  return std::find(std::begin(kLmsBauds), std::end(kLmsBauds), baud) != std::end(kLmsBauds);
}

}  // namespace scanbed::hw
