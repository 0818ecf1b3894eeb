// SPDX-License-Identifier: MIT
#include "hw/serial/attempts.hpp"

#include "hw/serial/device_refusal.hpp"

namespace scanbed::hw {
namespace {

SensorFault final_fault(const std::string& device, const SensorFault& fault) {
  const std::string text = fault.what();
  const bool is_timeout = fault.kind() == SensorFault::Kind::kTimeout;
  return {is_timeout ? SensorFault::Kind::kDisconnected : fault.kind(),
          text.starts_with(device) ? text : device + ": " + text};
}

void pause(const Attempts& attempts, const StopSignal& stop) {
  try {
    stop.sleep(attempts.pause_s);
  } catch (const Stopped&) {
    if (attempts.leave) attempts.leave();
    throw;
  }
}

}  // namespace

std::exception_ptr keep_trying(const Attempts& attempts, const StopSignal& stop) {
  try {
    while (true) {
      try {
        attempts.attempt();
      } catch (const DeviceRefusal&) {
        throw;
      } catch (const SensorFault& fault) {
        if (!attempts.may_go_on(fault)) throw final_fault(attempts.device, fault);
      }
      pause(attempts, stop);
    }
  } catch (const Stopped&) {
    return nullptr;
  } catch (const std::exception&) {
    return std::current_exception();
  }
}

}  // namespace scanbed::hw
