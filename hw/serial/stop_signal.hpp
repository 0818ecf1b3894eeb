// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

#include "hw/serial/file_descriptor.hpp"

namespace scanbed::hw {

/// Thrown where a wait ends since the signal was given: nothing failed, there is just no point in going on.
struct Stopped {};

/// Ends waits of other threads at once, and for good.
class StopSignal {
 public:
  /// @throws SensorFault where the system has no descriptor left.
  StopSignal();

  /// May be called from any thread, and from a signal handler.
  void give() noexcept;

  bool is_given() const { return is_given_.load(); }

  /// Sleeps; shorter where the signal is given. @throws Stopped then.
  void sleep(double duration_s) const;

 private:
  friend bool wait_for(int fd, short events, double timeout_s, const StopSignal& stop);
  FileDescriptor event_;
  std::atomic<bool> is_given_{false};
};

/// Waits until the descriptor can be read or written (POLLIN, POLLOUT) or has failed; false where `timeout_s`
/// passes first. A negative descriptor only waits for the time.
/// @throws Stopped where the signal is given, before or during the wait.
bool wait_for(int fd, short events, double timeout_s, const StopSignal& stop);

}  // namespace scanbed::hw
