// SPDX-License-Identifier: MIT
#include "scenarios/run/live_sensor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/errors/sensor_fault.hpp"

namespace scanbed::scenarios {
namespace {

using Clock = std::chrono::steady_clock;

constexpr RangeSensor::Seconds kStep{0.03};  // a stop is due within 0.2 s, and drivers need most of it

constexpr std::array<const char*, 5> kSeverities = {"no trouble", "a note", "a warning", "an error",
                                                    "a fatal error"};

}  // namespace

std::string describe(const SensorHealth& health) {
  const int severity = std::clamp(health.severity, 0, static_cast<int>(kSeverities.size()) - 1);
  std::string text = std::string("the laser reports ") + kSeverities.at(static_cast<std::size_t>(severity));
  if (health.is_polluted) text += ": its window is dirty";
  if (health.is_implausible)
    text += std::string(health.is_polluted ? " and" : ":") + " its values are doubtful";
  return text;
}

LiveSensor::LiveSensor(std::unique_ptr<RangeSensor> device, const LiveOptions& options)
    : device_(std::move(device)), options_(options) {
  if (options_.truth) reader_.emplace(*options_.truth);
}

const ScanGeometry& LiveSensor::geometry() const {
  return device_->geometry();
}

bool LiveSensor::wait_for_scan(LaserScan& scan) {
  const auto start = Clock::now();
  bool has_told = false;
  while (!options_.is_interrupted || !options_.is_interrupted()) {
    try {
      return device_->next(scan, kStep);
    } catch (const SensorFault& fault) {
      const Seconds waited = Clock::now() - start;
      if (fault.kind() != SensorFault::Kind::kTimeout || waited.count() > options_.patience_s) throw;
      const bool is_long = waited.count() >= options_.quiet_s;
      if (is_long && !std::exchange(has_told, true) && options_.warn) options_.warn(fault.what());
    }
  }
  return false;
}

void LiveSensor::watch(const SensorHealth& health) {
  if (health == health_) return;
  health_ = health;
  if (options_.warn) options_.warn(describe(health));
}

// Devices number all scans, also those that nobody took in time.
void LiveSensor::watch_numbers(std::int64_t index) {
  const std::int64_t num_dropped = index + 1 - num_scans_;
  if (num_dropped < num_dropped_to_tell_) return;
  while (num_dropped_to_tell_ <= num_dropped) num_dropped_to_tell_ *= 10;
  if (!options_.warn) return;
  options_.warn(fmt::format("scans come faster than they are taken: {} dropped so far", num_dropped));
}

bool LiveSensor::next(LaserScan& scan, Seconds /*timeout*/) {
  if (options_.limit && num_scans_ >= *options_.limit) return false;
  if (!wait_for_scan(scan)) return false;
  ++num_scans_;
  if (!first_s_) first_s_ = scan.time_s;
  if (options_.from_zero) scan.time_s -= *first_s_;
  watch(scan.health);
  watch_numbers(scan.index);
  truth_ = reader_ ? reader_->find(scan.range_m) : device_->truth();
  num_truths_ += truth_ != nullptr ? 1 : 0;
  return true;
}

}  // namespace scanbed::scenarios
