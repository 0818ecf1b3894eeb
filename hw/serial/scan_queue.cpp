// SPDX-License-Identifier: MIT
#include "hw/serial/scan_queue.hpp"

#include <utility>

#include "hw/serial/stop_signal.hpp"

namespace scanbed::hw {

void ScanQueue::push(LaserScan& scan) {
  std::unique_lock lock(mutex_);
  if (full_ == Full::kWaits) {
    changed_.wait(lock, [this] { return has_room() || is_closed_; });
    if (!has_room()) throw Stopped{};
  } else if (!has_room()) {
    waiting_.pop_front();
    ++num_dropped_;
  }
  scan.index = num_pushed_++;
  waiting_.push_back(scan);
  changed_.notify_all();
}

void ScanQueue::fail(std::exception_ptr reason) {
  const std::lock_guard lock(mutex_);
  failure_ = std::move(reason);
  changed_.notify_all();
}

void ScanQueue::close() {
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  changed_.notify_all();
}

ScanQueue::Popped ScanQueue::pop(LaserScan& scan, RangeSensor::Seconds timeout) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, timeout, [this] { return !waiting_.empty() || failure_ || is_closed_; });
  if (is_closed_) return Popped::kClosed;
  if (!waiting_.empty()) {
    scan = std::move(waiting_.front());
    waiting_.pop_front();
    changed_.notify_all();
    return Popped::kScan;
  }
  if (failure_) std::rethrow_exception(failure_);
  return Popped::kTimeout;
}

std::int64_t ScanQueue::num_pushed() const {
  const std::lock_guard lock(mutex_);
  return num_pushed_;
}

std::int64_t ScanQueue::num_dropped() const {
  const std::lock_guard lock(mutex_);
  return num_dropped_;
}

}  // namespace scanbed::hw
