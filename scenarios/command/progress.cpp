// SPDX-License-Identifier: MIT
#include "scenarios/command/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace scanbed::scenarios {
namespace {

constexpr std::chrono::milliseconds kPatience{500};
constexpr std::chrono::milliseconds kPause{100};

}  // namespace

Progress::Progress(std::string what, std::string unit)
    : what_(std::move(what)),
      unit_(std::move(unit)),
      is_terminal_(::isatty(STDERR_FILENO) == 1),
      next_(Clock::now() + kPatience) {}

Progress::~Progress() {
  // Back to the line's start, and wipe it.
  if (is_shown_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(std::int64_t count) {
  if (!is_terminal_ || Clock::now() < next_) return;
  next_ = Clock::now() + kPause;
  is_shown_ = true;
  std::fputs(fmt::format("\r{}: {} {}", what_, count, unit_).c_str(), stderr);
}

}  // namespace scanbed::scenarios
