// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <functional>
#include <string>

#include "core/errors/sensor_fault.hpp"
#include "hw/serial/stop_signal.hpp"

namespace scanbed::hw {

/// How a driver tries, again and again, to stream from a device.
struct Attempts {
  std::string device;    ///< for messages
  double pause_s = 1.0;  ///< between two
  /// Opens the device and streams until something fails, which it throws. Leaves with Stopped when the signal
  /// is given.
  std::function<void()> attempt;
  /// Whether there is another attempt after this fault.
  std::function<bool(const SensorFault&)> may_go_on;
  /// Where the signal is given between two attempts: what the last one could not leave in order. May be
  /// empty.
  std::function<void()> leave = {};
};

/// Goes on until the signal is given, and then returns null; or until a driver has to give up, and then
/// returns why: DeviceRefusal and what is no SensorFault at once, SensorFault where may_go_on() says so. That
/// one names the device, and is no timeout, after which asking again might succeed.
std::exception_ptr keep_trying(const Attempts& attempts, const StopSignal& stop);

}  // namespace scanbed::hw
