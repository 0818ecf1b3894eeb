// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/random/philox.hpp"
#include "sim/sensor/lms_options.hpp"

namespace scanbed::sim {

/// What an LMS 200 makes of an ideal return: Gaussian noise, then the nearest step, as a 13-bit word.
class LmsModel {
 public:
  /// @pre the options validate.
  LmsModel(const LmsOptions& options, std::uint64_t seed);

  /// The word of one beam: kLmsNoStopSignal where `ideal_range_m` is kNoEcho, kLmsBeyondMax where the noisy
  /// range is beyond the unit's greatest; noise below 0 gives 0. The same for the same seed, scan and beam.
  std::uint16_t measure(double ideal_range_m, std::int64_t scan, int beam) const;

 private:
  RandomSource range_noise_;
  double sigma_m_;
  RangeUnit unit_;
};

}  // namespace scanbed::sim
