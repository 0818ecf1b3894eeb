// SPDX-License-Identifier: MIT
#include "hw/serial/recovering_laser.hpp"

#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "hw/serial/final_fault.hpp"

namespace scanbed::hw {

struct RecoveringLaser::Impl {
  void work();
  bool try_again(const SensorFault& fault);
  void give(LaserScan& scan);
  void fail(std::exception_ptr fault);

  std::string name;
  RecoveryOptions options;
  Attempt attempt;
  ScanGeometry geometry;
  StopSignal stop;

  std::mutex mutex;
  std::condition_variable changed;
  std::deque<LaserScan> waiting;
  std::exception_ptr failure;
  std::string last_fault;
  std::int64_t num_scans = 0;
  int num_failures = 0;

  std::thread worker;
};

void RecoveringLaser::Impl::fail(std::exception_ptr fault) {
  const std::lock_guard lock(mutex);
  failure = std::move(fault);
  changed.notify_all();
}

bool RecoveringLaser::Impl::try_again(const SensorFault& fault) {
  const std::lock_guard lock(mutex);
  last_fault = fault.what();
  return num_scans > 0 || ++num_failures < options.num_first_attempts;
}

void RecoveringLaser::Impl::give(LaserScan& scan) {
  const std::lock_guard lock(mutex);
  scan.index = num_scans++;
  if (waiting.size() >= static_cast<std::size_t>(options.max_waiting)) waiting.pop_front();
  waiting.push_back(scan);
  changed.notify_all();
}

void RecoveringLaser::Impl::work() {
  while (true) {
    try {
      attempt([this](LaserScan& scan) { give(scan); }, stop);
    } catch (const Stopped&) {
      return;
    } catch (const DeviceRefusal&) {
      return fail(std::current_exception());
    } catch (const SensorFault& fault) {
      if (!try_again(fault)) return fail(std::make_exception_ptr(final_fault(name, fault)));
    } catch (const std::exception&) {
      return fail(std::current_exception());
    }
    try {
      stop.sleep(options.pause_s);
    } catch (const Stopped&) {
      return;
    }
  }
}

RecoveringLaser::RecoveringLaser(std::string name, const RecoveryOptions& options, Attempt attempt)
    : impl_(std::make_unique<Impl>()) {
  impl_->name = std::move(name);
  impl_->options = options;
  impl_->attempt = std::move(attempt);
  impl_->worker = std::thread([this] { impl_->work(); });
}

RecoveringLaser::~RecoveringLaser() {
  impl_->stop.give();
  impl_->worker.join();
}

const ScanGeometry& RecoveringLaser::geometry() const {
  return impl_->geometry;
}

bool RecoveringLaser::next(LaserScan& scan, Seconds timeout) {
  Impl& s = *impl_;
  std::unique_lock lock(s.mutex);
  s.changed.wait_for(lock, timeout, [&] { return !s.waiting.empty() || s.failure; });
  if (!s.waiting.empty()) {
    scan = std::move(s.waiting.front());
    s.waiting.pop_front();
    s.geometry = scan.geometry;
    return true;
  }
  if (s.failure) std::rethrow_exception(s.failure);
  throw SensorFault(
      SensorFault::Kind::kTimeout,
      s.name + ": no scan in time" + (s.last_fault.empty() ? "" : " (before: " + s.last_fault + ")"));
}

}  // namespace scanbed::hw
