// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/sensor/sensor_options.hpp"

namespace scanbed::sim {

/// A sensor by name, with all its effects: "sick_lms200", "hokuyo_urg04lx", "hokuyo_utm30lx", "rplidar_a1",
/// "sick_tim5xx" (a TiM561), or "ideal": the LMS 200's beams without any error.
///
/// @throws InputError listing the names where there is none of that name.
/// @par Source  The makers' data sheets: field of view, step, rate, limits and range errors. Assumed, since
///              the sheets are silent: spots other than the LMS 200's and UTM-30LX's, pulse lengths, what is
///              systematic in a stated accuracy and how it depends on range and surface, glass and dazzle.
///              The turning direction is not modelled: beams are measured from right to left.
SensorOptions sensor_preset(std::string_view name);

/// All names that sensor_preset knows; the LMS 200 first.
std::vector<std::string> sensor_preset_names();

}  // namespace scanbed::sim
