// SPDX-License-Identifier: MIT
#include "scenarios/run/live_sensor.hpp"

#include <utility>

#include "core/errors/sensor_fault.hpp"

namespace scanbed::scenarios {
namespace {

using Clock = std::chrono::steady_clock;

constexpr RangeSensor::Seconds kStep{0.1};

}  // namespace

LiveSensor::LiveSensor(std::unique_ptr<RangeSensor> device, const LiveOptions& options)
    : device_(std::move(device)), options_(options) {
  if (options_.truth) reader_.emplace(*options_.truth);
}

const ScanGeometry& LiveSensor::geometry() const {
  return device_->geometry();
}

bool LiveSensor::wait_for_scan(LaserScan& scan) {
  const auto start = Clock::now();
  while (!options_.is_interrupted || !options_.is_interrupted()) {
    try {
      return device_->next(scan, kStep);
    } catch (const SensorFault& fault) {
      const bool is_out_of_patience = Clock::now() - start > Seconds(options_.patience_s);
      if (fault.kind() != SensorFault::Kind::kTimeout || is_out_of_patience) throw;
    }
  }
  return false;
}

bool LiveSensor::next(LaserScan& scan, Seconds /*timeout*/) {
  if (options_.limit && num_scans_ >= *options_.limit) return false;
  if (!wait_for_scan(scan)) return false;
  ++num_scans_;
  truth_ = reader_ ? reader_->find(scan.range_m) : device_->truth();
  return true;
}

}  // namespace scanbed::scenarios
