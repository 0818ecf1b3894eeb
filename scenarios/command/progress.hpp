// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace scanbed::scenarios {

/// "static_hallway: 120 scans" on stderr, overwritten as it grows and wiped at the end. Silent where stderr
/// is no terminal, and for work that is done within half a second.
class Progress {
 public:
  /// @param unit  of what is counted.
  explicit Progress(std::string what, std::string unit = "scans");
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(std::int64_t count);

 private:
  using Clock = std::chrono::steady_clock;

  std::string what_;
  std::string unit_;
  bool is_terminal_;
  bool is_shown_ = false;
  Clock::time_point next_;
};

}  // namespace scanbed::scenarios
