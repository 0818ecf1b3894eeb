// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "hw/serial/bytes.hpp"
#include "hw/serial/file_descriptor.hpp"

namespace scanbed::hw {

/// A serial port made of software: what one program writes here another reads at path(), and the other way.
/// It has no baud of its own; host_baud() tells what the other program set.
class PseudoTerminal {
 public:
  /// @param link  a symbolic link to path() is put here, over an older link; empty: none.
  /// @throws InputError where the link would replace something that is no link.
  /// @throws SensorFault where the link cannot be made, or is that of another PseudoTerminal that still
  ///                     lives; and where the system has no pseudo-terminal left.
  explicit PseudoTerminal(std::filesystem::path link);
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;
  ~PseudoTerminal();

  /// Name of the other end.
  const std::string& path() const { return path_; }

  int host_baud() const;

  /// Appends what the other end wrote; never waits.
  void read(Bytes& bytes);

  /// Writes what the other end has room for; returns how many bytes that were. Never waits.
  std::size_t write(ByteView bytes);

  /// To be polled.
  int fd() const { return master_.get(); }

  /// Takes the port away, as if it were pulled out: the other end reads an end of file from now on.
  void unplug();
  bool is_plugged() const { return master_.is_open(); }

  /// Makes a new one under the same link. @throws as the constructor.
  void plug();

 private:
  void remove_link();

  std::filesystem::path link_;
  FileDescriptor master_;
  FileDescriptor slave_;  // held open: without any other end the master could not be polled
  std::string path_;
};

}  // namespace scanbed::hw
