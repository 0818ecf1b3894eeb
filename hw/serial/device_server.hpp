// SPDX-License-Identifier: MIT
#pragma once

#include "hw/serial/bytes.hpp"
#include "hw/serial/pseudo_terminal.hpp"
#include "hw/serial/stop_signal.hpp"
#include "hw/serial/tcp_link.hpp"

namespace scanbed::hw {

/// An emulated device without a wire: bytes in, bytes out, at times that the caller gives. Nothing waits
/// here.
class ByteDevice {
 public:
  ByteDevice() = default;
  ByteDevice(const ByteDevice&) = delete;
  ByteDevice& operator=(const ByteDevice&) = delete;
  virtual ~ByteDevice() = default;

  /// Hears what a host sent.
  virtual void receive(ByteView bytes, double now_s) = 0;

  /// Appends what the device has to say by now.
  virtual void run(double now_s, Bytes& out) = 0;

  /// When run() will have something next; infinity where only a request can bring that about.
  virtual double next_event_s() const = 0;

  /// The host closed its connection.
  virtual void hang_up() = 0;
};

/// Serves one host after another in the network until the signal is given.
void serve(ByteDevice& device, TcpListener& listener, const StopSignal& stop);

/// Serves a pseudo-terminal until the signal is given. The device does not notice who opens or closes it.
void serve(ByteDevice& device, PseudoTerminal& terminal, const StopSignal& stop);

}  // namespace scanbed::hw
