// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "core/scan/lms_word.hpp"
#include "hw/serial/bytes.hpp"

namespace scanbed::hw {

/// The configuration that a sensor keeps in its EEPROM, as it travels in telegrams 77h, F4h and F7h. Bytes
/// without a name here are kept as they came. Older firmware has 32 bytes, newer 34; more are kept as well.
class LmsConfiguration {
 public:
  /// A sensor's millimetre configuration: measuring mode 00, no indices.
  LmsConfiguration();

  /// Empty where there are fewer than 32 bytes or more than 64.
  static std::optional<LmsConfiguration> from_bytes(ByteView bytes);

  ByteView bytes() const { return bytes_; }

  std::uint8_t measuring_mode() const { return bytes_[5]; }
  bool is_centimetre() const { return bytes_[6] == 0; }
  RangeUnit unit() const { return is_centimetre() ? RangeUnit::kCentimetre : RangeUnit::kMillimetre; }

  /// Whether measured values are followed by a scan index and a telegram index.
  bool sends_indices() const { return (bytes_[4] & 0x02) != 0; }

  void set_availability(std::uint8_t bits) { bytes_[4] = bits; }
  void set_measuring_mode(std::uint8_t mode) { bytes_[5] = mode; }
  void set_unit(RangeUnit unit) { bytes_[6] = unit == RangeUnit::kMillimetre ? 1 : 0; }

  friend bool operator==(const LmsConfiguration&, const LmsConfiguration&) = default;

 private:
  Bytes bytes_;
};

}  // namespace scanbed::hw
