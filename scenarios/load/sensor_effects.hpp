// SPDX-License-Identifier: MIT
#pragma once

#include "scenarios/load/table.hpp"
#include "sim/sensor/sensor_options.hpp"

namespace scanbed::scenarios {

/// The keys of `sensor:` that say how a sensor errs: noise, bias, spot, dropout, dazzle, and effects, which
/// scales each of them (0: off). What the file leaves out stays as it is.
///
/// @throws InputError for what does not fit.
void load_effects(Table& sensor, sim::SensorOptions& options);

}  // namespace scanbed::scenarios
