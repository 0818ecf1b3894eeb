// SPDX-License-Identifier: MIT
#include "hw/cola/cola_scan.hpp"

#include <algorithm>
#include <cmath>

#include "hw/cola/cola_frame.hpp"

namespace scanbed::hw {
namespace {

constexpr std::uint32_t kMostValues = 10000;
constexpr std::uint32_t kMostChannels = 16;
constexpr std::uint32_t kFirstRange = 16;  // values below are codes
constexpr double kTick_rad = kPi / 1.8e6;  // a ten-thousandth of a degree

bool read(ColaTokens& tokens, std::uint32_t& value) {
  const auto number = tokens.next_hex();
  if (number) value = *number;
  return number.has_value();
}

bool skip(ColaTokens& tokens, int count) {
  std::uint32_t ignored = 0;
  bool is_fine = true;
  for (int i = 0; i < count && is_fine; ++i) is_fine = read(tokens, ignored);
  return is_fine;
}

bool read_values(ColaTokens& tokens, std::vector<std::uint32_t>& values) {
  std::uint32_t count = 0;
  if (!read(tokens, count) || count > kMostValues) return false;
  values.resize(count);
  return std::all_of(values.begin(), values.end(), [&](std::uint32_t& value) { return read(tokens, value); });
}

bool read_channel(ColaTokens& tokens, ColaChannel& channel) {
  channel.name = tokens.next();
  const auto scale = tokens.next_float();
  const auto offset = tokens.next_float();
  const auto first_angle = tokens.next_signed();
  if (!scale || !offset || !first_angle || !read(tokens, channel.step)) return false;
  channel.scale = *scale;
  channel.offset = *offset;
  channel.first_angle = *first_angle;
  return read_values(tokens, channel.values);
}

/// Channels of 16 bits, or of 8: the same form twice.
bool read_channels(ColaTokens& tokens, std::vector<ColaChannel>& channels) {
  std::uint32_t count = 0;
  if (!read(tokens, count) || count > kMostChannels) return false;
  for (std::uint32_t i = 0; i < count; ++i) {
    ColaChannel channel;
    if (!read_channel(tokens, channel)) return false;
    channels.push_back(std::move(channel));
  }
  return true;
}

bool read_head(ColaTokens& tokens, ColaScan& scan) {
  const std::string_view kind = tokens.next();
  if ((kind != "sSN" && kind != "sRA") || tokens.next() != "LMDscandata") return false;
  // Version, device and serial number; first status byte.
  if (!skip(tokens, 4) || !read(tokens, scan.status)) return false;
  // Counts of telegrams and of scans.
  if (!skip(tokens, 2) || !read(tokens, scan.start_us) || !read(tokens, scan.sent_us)) return false;
  // Two input and two output bytes, one reserved.
  if (!skip(tokens, 5) || !read(tokens, scan.frequency_chz) || !skip(tokens, 1)) return false;
  std::uint32_t num_encoders = 0;
  return read(tokens, num_encoders) && num_encoders <= 3 && skip(tokens, static_cast<int>(2 * num_encoders));
}

SensorHealth health_of(std::uint32_t status) {
  const bool is_polluted = status == 2 || status == 5;
  const int severity = status == 0 ? 0 : status == 2 ? 2 : 3;
  return {severity, is_polluted, false};
}

ScanGeometry geometry_of(const ColaScan& telegram, const ColaChannel& channel) {
  ScanGeometry geometry;
  geometry.num_beams = static_cast<int>(channel.values.size());
  // A third of a degree is sent as 0.3333: the whole step is meant.
  const double per_degree = std::round(10000.0 / channel.step);
  const bool is_fraction = std::abs(10000.0 / per_degree - channel.step) < 1.0;
  geometry.step_rad = is_fraction ? radians(1.0 / per_degree) : channel.step * kTick_rad;
  geometry.first_rad = channel.first_angle * kTick_rad - kPi / 2;
  geometry.min_range_m = kFirstRange * channel.scale / 1000.0;
  if (telegram.frequency_chz > 0) {
    geometry.timing.rotation_s = 100.0 / telegram.frequency_chz;
    geometry.timing.step_s = geometry.timing.rotation_s * geometry.step_rad / (2.0 * kPi);
  }
  return geometry;
}

}  // namespace

double ColaScan::age_s() const {
  const double age_s = 1e-6 * (sent_us - start_us);  // modulo 2^32, as the counter
  return age_s <= 1.0 ? age_s : 0.0;
}

std::optional<ColaScan> parse_cola_scan(std::string_view body) {
  ColaTokens tokens(body);
  ColaScan scan;
  if (!read_head(tokens, scan) || !read_channels(tokens, scan.channels)) return std::nullopt;
  read_channels(tokens, scan.channels);  // remission; some firmware ends before
  return scan;
}

bool to_laser_scan(const ColaScan& telegram, LaserScan& scan) {
  const auto found = std::find_if(telegram.channels.begin(), telegram.channels.end(),
                                  [](const ColaChannel& channel) { return channel.name == "DIST1"; });
  if (found == telegram.channels.end() || found->step == 0 || found->step > 100000) return false;
  if (!(found->scale > 0.0F && found->scale < 1000.0F) || !std::isfinite(found->offset)) return false;
  scan.geometry = geometry_of(telegram, *found);
  if (!fault_of(scan.geometry).empty()) return false;
  scan.X_OR.reset();
  scan.source.clear();
  scan.health = health_of(telegram.status);
  scan.range_m.clear();
  for (const std::uint32_t value : found->values) {
    const double range_m = (value * static_cast<double>(found->scale) + found->offset) / 1000.0;
    scan.range_m.push_back(value < kFirstRange || range_m <= 0.0 ? kNoEcho : range_m);
  }
  return true;
}

}  // namespace scanbed::hw
