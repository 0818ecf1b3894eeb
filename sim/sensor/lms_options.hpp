// SPDX-License-Identifier: MIT
#pragma once

#include "sim/sensor/sensor_options.hpp"

namespace scanbed::sim {

/// The sensor's options under the name of the laser that they were first made for.
using LmsOptions = SensorOptions;

}  // namespace scanbed::sim
