// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hw/serial/byte_link.hpp"

namespace scanbed::hw {

/// A serial port: raw, 8 data bits, no parity, one stop bit, no handshake, and nobody else's meanwhile.
class SerialPort final : public ByteLink {
 public:
  /// @param path  a device; names below /dev/serial/by-id stay the same when it is plugged in again.
  /// @throws SensorFault kDisconnected saying what to do: no such port, no permission, in use, not a port.
  explicit SerialPort(const std::string& path);
  ~SerialPort() override;

  std::size_t read(std::span<std::uint8_t> buffer, double timeout_s, const StopSignal& stop) override;

  /// Above 115200 baud bytes are sent one at a time with 60 us between them: an LMS at 500000 baud wants at
  /// least 55.
  void write(ByteView bytes, const StopSignal& stop) override;

  void flush_input() override;

  /// Any baud that the hardware can make, in the standard table or not. Forgets what arrived at the old one.
  /// @throws SensorFault where the driver refuses it.
  void set_baud(int baud) override;

  /// 0 for a USB device that is a port itself: nothing of it goes at a baud.
  double byte_s() const override { return is_usb_device_ ? 0.0 : 10.0 / baud_; }

  int baud() const { return baud_; }
  const std::string& path() const { return path_; }

 private:
  [[noreturn]] void lose(const char* what) const;
  void write_some(ByteView& bytes, const StopSignal& stop);

  std::string path_;
  FileDescriptor fd_;
  int baud_ = 0;
  bool is_usb_device_;
};

/// Opens a port and leaves it as it was: its settings, and what is sent and received.
/// @throws SensorFault as SerialPort does where there is no port of that name, or it may not be opened.
void check_port(const std::string& path);

/// Baud that the terminal behind a descriptor is set to, of a pseudo-terminal's master: that of its other
/// end. 0 where it is none.
int terminal_baud(int fd);

}  // namespace scanbed::hw
