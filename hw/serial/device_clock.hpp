// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

namespace scanbed::hw {

/// The clock of a device that stamps its scans, told in this machine's time. Its counter wraps; what a
/// network adds to an arrival is never negative, so that the quickest arrivals tell how the two clocks stand.
class DeviceClock {
 public:
  /// @param bits    of the device's counter.
  /// @param tick_s  of one count.
  DeviceClock(int bits, double tick_s) : modulus_(std::int64_t{1} << bits), tick_s_(tick_s) {}

  /// When the stamp was taken, by this machine's clock; never later than `arrival_s`. Times never go back:
  /// where a quick arrival shows that those before were late, they stand still until it has caught up.
  double to_local_s(std::int64_t stamp, double arrival_s);

 private:
  std::int64_t modulus_;
  double tick_s_;
  std::int64_t base_ = 0;
  std::int64_t last_ = -1;
  double last_arrival_s_ = 0.0;
  double local_s_ = -std::numeric_limits<double>::infinity();
  double offset_s_ = std::numeric_limits<double>::infinity();  // local minus device, the least seen so far
};

}  // namespace scanbed::hw
