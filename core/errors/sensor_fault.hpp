// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace scanbed {

/// A source of scans that fails: thrown by RangeSensor::next. The message says what to do about it.
class SensorFault : public std::runtime_error {
 public:
  enum class Kind {
    kTimeout,       ///< no scan in the time given; asking again may succeed
    kDisconnected,  ///< the device or its file went away
    kProtocol,      ///< what arrived makes no sense
    kSimulator,     ///< an engine refused to go on
  };

  SensorFault(Kind kind, const std::string& what) : std::runtime_error(what), kind_(kind) {}
  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

}  // namespace scanbed
