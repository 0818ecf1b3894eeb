// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "core/errors/sensor_fault.hpp"
#include "hw/serial/bytes.hpp"
#include "hw/serial/stop_signal.hpp"

namespace scanbed::hw {

/// A baud that a port cannot do.
class UnsupportedBaud : public SensorFault {
 public:
  explicit UnsupportedBaud(const std::string& what) : SensorFault(Kind::kDisconnected, what) {}
};

/// A link whose other end went away, or is not there.
inline SensorFault link_fault(const std::string& message) {
  return {SensorFault::Kind::kDisconnected, message};
}

/// Bytes to and from a device, over a serial port or a network.
class ByteLink {
 public:
  ByteLink() = default;
  ByteLink(const ByteLink&) = delete;
  ByteLink& operator=(const ByteLink&) = delete;
  virtual ~ByteLink() = default;

  /// Waits for at least one byte and gives what is there; 0 where `timeout_s` passes first.
  /// @throws SensorFault kDisconnected where the other end went away; Stopped.
  virtual std::size_t read(std::span<std::uint8_t> buffer, double timeout_s, const StopSignal& stop) = 0;

  /// Writes all; waits no longer than the link takes for it, and a second.
  /// @throws SensorFault as read(), and kTimeout where the link takes nothing; Stopped.
  virtual void write(ByteView bytes, const StopSignal& stop) = 0;

  /// Forgets what arrived and was not read.
  virtual void flush_input() = 0;

  /// @throws UnsupportedBaud where the link has bauds, but not this one. Links without bauds ignore it.
  virtual void set_baud(int /*baud*/) {}

  /// What a byte takes on the wire; 0 for links that are no wire at a baud.
  virtual double byte_s() const { return 0.0; }

 protected:
  static constexpr double kWritePatience_s = 1.0;
};

}  // namespace scanbed::hw
