// SPDX-License-Identifier: MIT
#include "hw/sick/emulator_server.hpp"

#include <poll.h>

#include <algorithm>
#include <utility>

#include "hw/serial/steady_clock.hpp"

namespace scanbed::hw {
namespace {

// Bounds how late a change of the host's baud, which wakes nobody, is seen.
constexpr double kLongestSleep_s = 0.1;

}  // namespace

EmulatorServer::EmulatorServer(const EmulatorOptions& options, ScanSupply source, ScanFeed::Observer observer,
                               std::filesystem::path link)
    : options_(options),
      link_(std::move(link)),
      terminal_(link_),
      lms_(options, std::move(source), std::move(observer)) {}

std::string EmulatorServer::port() const {
  return link_.empty() ? terminal_.path() : link_.string();
}

void EmulatorServer::flush_pending() {
  const std::size_t num_written = terminal_.write(pending_);
  pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(num_written));
  // A wire does not wait for whoever does not read; an unpaced one does, or scans would be lost.
  if (options_.is_paced) pending_.clear();
}

void EmulatorServer::serve(const StopSignal& stop) {
  received_.clear();
  terminal_.read(received_);
  const double now_s = steady_now_s();
  const int host_baud = terminal_.host_baud();
  lms_.receive(received_, host_baud, now_s);
  if (pending_.empty()) lms_.run(now_s, host_baud, pending_);
  flush_pending();
  const short events = pending_.empty() ? POLLIN : POLLIN | POLLOUT;
  const double left_s = pending_.empty() ? lms_.next_event_s() - steady_now_s() : kLongestSleep_s;
  if (left_s > 0.0) wait_for(terminal_.fd(), events, std::min(left_s, kLongestSleep_s), stop);
}

void EmulatorServer::run(const StopSignal& stop) {
  try {
    while (!stop.is_given()) {
      serve(stop);
      if (!lms_.take_unplug()) continue;
      terminal_.unplug();
      pending_.clear();
      stop.sleep(options_.unplug_s);
      terminal_.plug();
    }
  } catch (const Stopped&) {
    return;
  }
}

}  // namespace scanbed::hw
