// SPDX-License-Identifier: MIT
#include "sim/sensor/lms_model.hpp"

#include <cmath>

namespace scanbed::sim {

LmsModel::LmsModel(const LmsOptions& options, std::uint64_t seed)
    : range_noise_(seed, "lms.range_noise"), sigma_m_(options.noise_sigma_m), unit_(options.unit) {}

std::uint16_t LmsModel::measure(double ideal_range_m, std::int64_t scan, int beam) const {
  if (sigma_m_ == 0.0 || !std::isfinite(ideal_range_m)) return encode_lms_word(ideal_range_m, unit_);
  return encode_lms_word(ideal_range_m + sigma_m_ * range_noise_.gaussian(scan, beam), unit_);
}

}  // namespace scanbed::sim
