// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/scan/laser_scan.hpp"
#include "hw/sick/scan_clock.hpp"
#include "hw/sick/scan_telegram.hpp"
#include "hw/sick/sick_options.hpp"

namespace scanbed::hw {

/// Makes scans of the telegrams of a stream: words to ranges, and turns of the mirror put together where the
/// stream has them one by one. A telegram that is not what was configured is refused: the check word misses
/// some damage, and an old stream may still be in the pipe.
class ScanAssembler {
 public:
  ScanAssembler(const SickOptions& options, const LmsWordFormat& format, bool has_indices);

  enum class Outcome { kScan, kPart, kRefused };

  /// @returns kScan where `scan` is a new one, all but its index.
  Outcome take(ByteView body, const TelegramArrival& arrival, LaserScan& scan);

  /// Gives up the turns of a scan that is not complete: where damage came between, the next ones may be
  /// another scan's.
  void forget_turns() { turns_ = 0; }

  const ScanGeometry& geometry() const { return geometry_; }

 private:
  Outcome take_turn(const TelegramArrival& arrival, std::size_t num_bytes, LaserScan& scan);
  void stamp(double first_beam_s, LaserScan& scan) const;

  ScanExpectation expected_;
  LmsWordFormat format_;
  ScanGeometry geometry_;
  ScanGeometry turn_geometry_;
  ScanClock clock_;
  ScanTelegram telegram_;
  // The turns of one scan so far.
  unsigned turns_ = 0;  // bit i: turn i is there
  double first_turn_s_ = 0.0;
  int last_turn_ = 0;
  bool is_in_order_ = true;  // from turn 0 on
  SensorHealth health_;
  std::vector<std::uint16_t> words_;
};

}  // namespace scanbed::hw
