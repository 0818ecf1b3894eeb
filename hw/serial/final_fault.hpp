// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/errors/sensor_fault.hpp"

namespace scanbed::hw {

/// A fault with which a driver gives up. It is no timeout, after which asking again may succeed, and it names
/// the device.
inline SensorFault final_fault(const std::string& device, const SensorFault& fault) {
  const std::string text = fault.what();
  const bool is_timeout = fault.kind() == SensorFault::Kind::kTimeout;
  return {is_timeout ? SensorFault::Kind::kDisconnected : fault.kind(),
          text.starts_with(device) ? text : device + ": " + text};
}

}  // namespace scanbed::hw
