// SPDX-License-Identifier: MIT
#include "hw/serial/stop_signal.hpp"

#include <poll.h>
#include <sys/eventfd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/errors/sensor_fault.hpp"
#include "hw/serial/steady_clock.hpp"

namespace scanbed::hw {

StopSignal::StopSignal() : event_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
  if (event_.is_open()) return;
  throw SensorFault(SensorFault::Kind::kDisconnected, std::string("eventfd: ") + std::strerror(errno));
}

void StopSignal::give() noexcept {
  is_given_.store(true);
  const std::uint64_t one = 1;
  // Fails only where the counter is full, and then it wakes whom it should already.
  [[maybe_unused]] const auto written = ::write(event_.get(), &one, sizeof one);
}

void StopSignal::sleep(double duration_s) const {
  wait_for(-1, 0, duration_s, *this);
}

bool wait_for(int fd, short events, double timeout_s, const StopSignal& stop) {
  const double deadline_s = steady_now_s() + timeout_s;
  std::array<pollfd, 2> fds{{{stop.event_.get(), POLLIN, 0}, {fd, events, 0}}};
  while (true) {
    const double left_s = std::clamp(deadline_s - steady_now_s(), 0.0, 3600.0);
    const int ready = ::poll(fds.data(), fds.size(), static_cast<int>(std::ceil(left_s * 1e3)));
    if (stop.is_given()) throw Stopped{};
    if (ready > 0 && fds[1].revents != 0) return true;
    if (ready < 0 && errno != EINTR) return true;  // the call that follows says what is wrong
    if (steady_now_s() >= deadline_s) return false;
  }
}

}  // namespace scanbed::hw
