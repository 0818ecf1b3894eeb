// SPDX-License-Identifier: MIT
#include "hw/sick/scan_feed.hpp"

#include <utility>

#include "core/errors/sensor_fault.hpp"

namespace scanbed::hw {
namespace {

constexpr RangeSensor::Seconds kPatience{1.0};

}  // namespace

ScanFeed::ScanFeed(ScanSupply source, Observer observer)
    : source_(std::move(source)), observer_(std::move(observer)) {}

void ScanFeed::restart(const LmsStreamSettings& settings, const LmsWordFormat& format) {
  settings_ = settings;
  format_ = format;
  sensor_ = source_(settings);
}

void ScanFeed::take_scan() {
  if (sensor_->next(scan_, kPatience)) return;
  sensor_ = source_(settings_);
  if (sensor_->next(scan_, kPatience)) return;
  throw SensorFault(SensorFault::Kind::kProtocol, "emulator: its source holds no scan");
}

const std::vector<std::uint16_t>& ScanFeed::next() {
  take_scan();
  const LmsVariant& variant = settings_.variant;
  const double step_rad = radians(variant.resolution_cdeg / 100.0);
  const double first_rad = -0.5 * radians(variant.fov_deg);
  words_.resize(static_cast<std::size_t>(variant.num_beams()));
  for (std::size_t i = 0; i < words_.size(); ++i) {
    const double range_m = range_towards(scan_, first_rad + static_cast<double>(i) * step_rad);
    words_[i] = encode_lms_word(range_m, settings_.unit, format_.range_bits);
  }
  const SentScan sent{num_scans_++, scan_, words_, settings_.unit, format_, sensor_->truth()};
  if (observer_) observer_(sent);
  return words_;
}

}  // namespace scanbed::hw
