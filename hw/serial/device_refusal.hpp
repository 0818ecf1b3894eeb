// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/errors/sensor_fault.hpp"

namespace scanbed::hw {

/// The sensor understood and said no: asking again would not help.
class DeviceRefusal : public SensorFault {
 public:
  explicit DeviceRefusal(const std::string& what) : SensorFault(Kind::kProtocol, what) {}
};

}  // namespace scanbed::hw
