// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "core/detect/detector_options.hpp"

namespace scanbed {

/// One row of the paper's Table II: the public name of a parameter, in configuration files and on the wire.
struct TableTwoEntry {
  std::string_view name;
  double default_value;      ///< as printed
  std::string_view unit;     ///< "mm", "rad", "m" or empty
  std::string_view option;   ///< that it stands for, as core/options names it; empty for the laser
  std::string_view meaning;  ///< one line
  double min_value;
  double max_value;
  bool whole_number;
  double (*get)(const DetectorOptions&);  ///< in the table's unit
  void (*set)(DetectorOptions&, double);  ///< in the table's unit; the value lies in [min_value, max_value]
};

/// The rows, in the order of the paper.
std::span<const TableTwoEntry> table_two();

/// Sets the option that a Table II name stands for, converting its unit (lengths are in mm, line_err in m).
///
/// `laser`, the index of Player's laser device, selects no option of a detector and so accepts 0 alone.
/// @throws InputError for an unknown name (and the known ones), or naming parameter, value and allowed range.
void set_table_two(DetectorOptions& options, std::string_view name, double value);

}  // namespace scanbed
