// SPDX-License-Identifier: MIT
#include "hw/sick/scan_assembler.hpp"

#include <algorithm>
#include <cmath>

#include "hw/sick/lms_variant.hpp"
#include "hw/sick/telegram.hpp"

namespace scanbed::hw {
namespace {

constexpr unsigned kAllTurns = 0x0F;
constexpr std::size_t kNumTurns = 4;

// The worst of what several turns say.
SensorHealth worse(const SensorHealth& a, const SensorHealth& b) {
  return {std::max(a.severity, b.severity), a.is_polluted || b.is_polluted,
          a.is_implausible || b.is_implausible};
}

// Between the turns that a slow link carries there are others, which it leaves out.
double between_turns_s(double measured_s) {
  return kLmsRotation_s * std::max(1.0, std::round(measured_s / kLmsRotation_s));
}

}  // namespace

ScanAssembler::ScanAssembler(const SickOptions& options, const LmsWordFormat& format, bool has_indices)
    : expected_{.variant = options.variant(),
                .unit = options.unit,
                .has_indices = has_indices,
                .is_partial = options.is_interlaced_here()},
      format_(format),
      geometry_(sick_geometry(options, format)),
      turn_geometry_(geometry_),
      clock_(options.baud, !options.is_lossless),
      words_(static_cast<std::size_t>(geometry_.num_beams)) {
  turn_geometry_.timing.num_rotations = 1;
  turn_geometry_.num_beams = 181;
}

void ScanAssembler::stamp(double first_beam_s, LaserScan& scan) const {
  scan.time_s = first_beam_s;
  scan.geometry = geometry_;
  scan.X_OR.reset();
  scan.source.clear();
}

ScanAssembler::Outcome ScanAssembler::take(ByteView body, const TelegramArrival& arrival, LaserScan& scan) {
  if (!parse_scan(body, telegram_) || !matches(telegram_, expected_)) return Outcome::kRefused;
  const std::size_t num_bytes = body.size() + kFrameBytes;
  if (expected_.is_partial) return take_turn(arrival, num_bytes, scan);
  stamp(clock_.first_beam_s(arrival, num_bytes, geometry_), scan);
  scan.health = telegram_.status.health();
  scan.range_m.resize(telegram_.words.size());
  decode_lms_words(telegram_.words, expected_.unit, format_, scan.range_m);
  return Outcome::kScan;
}

ScanAssembler::Outcome ScanAssembler::take_turn(const TelegramArrival& arrival, std::size_t num_bytes,
                                                LaserScan& scan) {
  const unsigned turn = 1U << telegram_.partial;
  const double turn_s = clock_.first_beam_s(arrival, num_bytes, turn_geometry_);
  // Scans begin with turn 0; where a slow link leaves turns out, the others come in another order. A turn
  // that is there already belongs to another scan.
  if ((turns_ & turn) != 0) forget_turns();
  if (turns_ == 0 && telegram_.partial != 0) return Outcome::kPart;
  if (turns_ == 0) {
    first_turn_s_ = turn_s;
    is_in_order_ = true;
    health_ = {};
  } else {
    is_in_order_ = is_in_order_ && telegram_.partial == last_turn_ + 1;
  }
  last_turn_ = telegram_.partial;
  for (std::size_t i = 0; i < telegram_.words.size(); ++i) {
    words_[i * kNumTurns + static_cast<std::size_t>(telegram_.partial)] = telegram_.words[i];
  }
  health_ = worse(health_, telegram_.status.health());
  turns_ |= turn;
  if (turns_ != kAllTurns) return Outcome::kPart;
  turns_ = 0;
  stamp(first_turn_s_, scan);
  if (is_in_order_)
    scan.geometry.timing.rotation_s =
        between_turns_s((turn_s - first_turn_s_) / static_cast<double>(kNumTurns - 1));
  scan.health = health_;
  scan.range_m.resize(words_.size());
  decode_lms_words(words_, expected_.unit, format_, scan.range_m);
  return Outcome::kScan;
}

}  // namespace scanbed::hw
