// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hw/serial/byte_link.hpp"

namespace scanbed::hw {

/// A connection to a device in the network.
class TcpLink final : public ByteLink {
 public:
  /// Connects within `timeout_s`.
  /// @param host  a name or an address; IPv4 or IPv6.
  /// @throws SensorFault kDisconnected saying what to check. Stopped.
  TcpLink(const std::string& host, int port, double timeout_s, const StopSignal& stop);

  /// Takes over a connection that was accepted.
  explicit TcpLink(FileDescriptor fd);

  std::size_t read(std::span<std::uint8_t> buffer, double timeout_s, const StopSignal& stop) override;
  void write(ByteView bytes, const StopSignal& stop) override;
  void flush_input() override;

 private:
  std::string name_;
  FileDescriptor fd_;
};

/// A port of this machine, on the loop-back interface alone, that waits for a connection.
class TcpListener {
 public:
  /// @param port  0: any free one.
  /// @throws SensorFault where it cannot be had.
  explicit TcpListener(int port);

  int port() const { return port_; }
  int fd() const { return fd_.get(); }

  /// A connection that waits; not open where there is none.
  FileDescriptor accept();

 private:
  FileDescriptor fd_;
  int port_ = 0;
};

}  // namespace scanbed::hw
