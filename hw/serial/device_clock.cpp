// SPDX-License-Identifier: MIT
#include "hw/serial/device_clock.hpp"

#include <algorithm>

namespace scanbed::hw {
namespace {

// By how much two quartz clocks may drift apart.
constexpr double kDrift = 100e-6;

}  // namespace

double DeviceClock::to_local_s(std::int64_t stamp, double arrival_s) {
  if (last_ >= 0) {
    if (stamp < last_) base_ += modulus_;
    offset_s_ += kDrift * (arrival_s - last_arrival_s_);
  }
  last_ = stamp;
  last_arrival_s_ = arrival_s;
  const double device_s = static_cast<double>(base_ + stamp) * tick_s_;
  offset_s_ = std::min(offset_s_, arrival_s - device_s);
  local_s_ = std::max(local_s_, device_s + offset_s_);
  return local_s_;
}

}  // namespace scanbed::hw
