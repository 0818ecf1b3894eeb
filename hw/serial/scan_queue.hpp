// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <mutex>

#include "core/scan/range_sensor.hpp"

namespace scanbed::hw {

/// Scans between the thread that reads a device and the one that asks for them. All calls may come from any
/// thread.
class ScanQueue {
 public:
  enum class Full { kDropsOldest, kWaits };
  enum class Popped { kScan, kTimeout, kClosed };

  ScanQueue(int most_waiting, Full full) : most_waiting_(most_waiting), full_(full) {}

  /// Numbers the scan and hands on a copy of it; where too many wait, drops the oldest or waits for room.
  /// @throws Stopped where the queue is, or becomes, closed while there is no room.
  void push(LaserScan& scan);
  /// No further scan comes, for this reason.
  void fail(std::exception_ptr reason);
  /// Whoever waits stops to.
  void close();

  /// The oldest scan. @throws what fail() was told, once no scan waits any more.
  Popped pop(LaserScan& scan, RangeSensor::Seconds timeout);

  std::int64_t num_pushed() const;
  std::int64_t num_dropped() const;

 private:
  bool has_room() const { return waiting_.size() < static_cast<std::size_t>(most_waiting_); }

  const int most_waiting_;
  const Full full_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<LaserScan> waiting_;
  std::exception_ptr failure_;
  std::int64_t num_pushed_ = 0;
  std::int64_t num_dropped_ = 0;
  bool is_closed_ = false;
};

}  // namespace scanbed::hw
