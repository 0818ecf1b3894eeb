// SPDX-License-Identifier: MIT
#pragma once

#include <exception>

#include "core/errors/input_error.hpp"
#include "core/errors/sensor_fault.hpp"

namespace scanbed::scenarios {

/// What ended the work on a source's scans: a recording that is cut off, a device that failed; empty where
/// nothing did. What was made until then is to be written all the same, before the fault goes on.
template <typename Work>
std::exception_ptr source_fault(const Work& work) {
  try {
    work();
  } catch (const InputError&) {
    return std::current_exception();
  } catch (const SensorFault&) {
    return std::current_exception();
  }
  return nullptr;
}

}  // namespace scanbed::scenarios
