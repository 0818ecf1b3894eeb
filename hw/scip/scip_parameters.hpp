// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/scan/scan_geometry.hpp"

namespace scanbed::hw {

/// What a sensor answers to PP: its steps and limits.
struct ScipParameters {
  std::string model;         ///< MODL
  int min_range_mm = 0;      ///< DMIN
  int max_range_mm = 0;      ///< DMAX
  int steps_per_turn = 0;    ///< ARES
  int first_step = 0;        ///< AMIN
  int last_step = 0;         ///< AMAX
  int front_step = 0;        ///< AFRT
  int turns_per_minute = 0;  ///< SCAN

  int num_beams() const { return last_step - first_step + 1; }
  double scan_period_s() const { return 60.0 / turns_per_minute; }
  ScanGeometry geometry() const;
};

/// Reads the lines of a reply to PP, echo and status included. Keys that are unknown are left alone.
/// @returns empty where a key is missing or a value cannot be; a wrong sum makes a key count as missing.
std::optional<ScipParameters> parse_scip_parameters(const std::vector<std::string>& lines);

/// Of two common models, as real sensors send them: UTM-30LX and URG-04LX.
ScipParameters utm_30lx();
ScipParameters urg_04lx();

/// The lines of a reply to PP, without echo and status.
std::string to_scip_info(const ScipParameters& parameters);

/// "KEY:value;" and the sum, which leaves the semicolon out.
std::string scip_info_line(const std::string& text);

}  // namespace scanbed::hw
