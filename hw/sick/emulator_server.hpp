// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "hw/serial/pseudo_terminal.hpp"
#include "hw/serial/stop_signal.hpp"
#include "hw/sick/emulated_lms.hpp"

namespace scanbed::hw {

/// An emulated LMS 200 behind a pseudo-terminal.
class EmulatorServer {
 public:
  /// @param link  name for the port; empty: only port() names it.
  /// @throws InputError where the options do not validate; what PseudoTerminal throws for the link.
  EmulatorServer(const EmulatorOptions& options, ScanSupply source, ScanFeed::Observer observer,
                 std::filesystem::path link);

  /// What a host opens: the link where there is one.
  std::string port() const;

  /// Serves until the signal is given.
  /// @throws what the source of the scans throws.
  void run(const StopSignal& stop);

  /// The sensor; while run() runs, only its own thread (an observer) may touch it.
  EmulatedLms& lms() { return lms_; }

 private:
  void serve(const StopSignal& stop);
  void flush_pending();

  EmulatorOptions options_;
  std::filesystem::path link_;
  PseudoTerminal terminal_;
  EmulatedLms lms_;
  Bytes received_;
  Bytes pending_;
};

}  // namespace scanbed::hw
