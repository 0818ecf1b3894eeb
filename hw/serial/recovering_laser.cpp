// SPDX-License-Identifier: MIT
#include "hw/serial/recovering_laser.hpp"

#include <mutex>
#include <thread>
#include <utility>

#include "hw/serial/attempts.hpp"
#include "hw/serial/scan_queue.hpp"
#include "hw/serial/steady_clock.hpp"

namespace scanbed::hw {
namespace {

constexpr double kOldestScan_s = 1.0;  // what a device may send first is no older

}  // namespace

struct RecoveringLaser::Impl {
  Impl(std::string given_name, const RecoveryOptions& given, Attempt given_attempt);
  ~Impl();

  void work();
  void give(LaserScan& scan);
  bool may_go_on(const SensorFault& fault);

  const std::string name;
  const RecoveryOptions options;
  const Attempt attempt;
  ScanGeometry geometry;
  StopSignal stop;
  ScanQueue queue;
  // A first scan may have begun before this did, and its time must not be negative: recordings have none.
  const double start_s = steady_now_s() - kOldestScan_s;
  int num_failures = 0;  // of the worker alone

  std::mutex mutex;
  std::string last_fault;

  std::thread worker;
};

RecoveringLaser::Impl::Impl(std::string given_name, const RecoveryOptions& given, Attempt given_attempt)
    : name(std::move(given_name)),
      options(given),
      attempt(std::move(given_attempt)),
      queue(given.max_waiting, ScanQueue::Full::kDropsOldest) {
  worker = std::thread([this] { work(); });
}

RecoveringLaser::Impl::~Impl() {
  stop.give();
  worker.join();
}

void RecoveringLaser::Impl::give(LaserScan& scan) {
  scan.time_s -= start_s;
  queue.push(scan);
}

bool RecoveringLaser::Impl::may_go_on(const SensorFault& fault) {
  {
    const std::lock_guard lock(mutex);
    last_fault = fault.what();
  }
  return queue.num_pushed() > 0 || ++num_failures < options.num_first_attempts;
}

void RecoveringLaser::Impl::work() {
  const Attempts attempts{.device = name,
                          .pause_s = options.pause_s,
                          .attempt = [this] { attempt([this](LaserScan& scan) { give(scan); }, stop); },
                          .may_go_on = [this](const SensorFault& fault) { return may_go_on(fault); }};
  if (const auto reason = keep_trying(attempts, stop)) queue.fail(reason);
}

RecoveringLaser::RecoveringLaser(std::string name, const RecoveryOptions& options, Attempt attempt)
    : impl_(std::make_unique<Impl>(std::move(name), options, std::move(attempt))) {}

RecoveringLaser::~RecoveringLaser() = default;

const ScanGeometry& RecoveringLaser::geometry() const {
  return impl_->geometry;
}

bool RecoveringLaser::next(LaserScan& scan, Seconds timeout) {
  Impl& s = *impl_;
  if (s.queue.pop(scan, timeout) == ScanQueue::Popped::kScan) {
    s.geometry = scan.geometry;
    return true;
  }
  const std::lock_guard lock(s.mutex);
  throw SensorFault(
      SensorFault::Kind::kTimeout,
      s.name + ": no scan in time" + (s.last_fault.empty() ? "" : " (before: " + s.last_fault + ")"));
}

}  // namespace scanbed::hw
