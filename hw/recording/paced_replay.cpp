// SPDX-License-Identifier: MIT
#include "hw/recording/paced_replay.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <utility>

#include "core/errors/input_error.hpp"
#include "core/text/number_text.hpp"

namespace scanbed::hw {

void ReplayOptions::validate() const {
  if (speed) require(*speed > 0.0 && *speed <= 1e6, "log.speed", *speed, "(0, 1e6]");
  require(from_s >= 0.0, "log.from", from_s, ">= 0");
  require(to_s >= from_s, "log.to", to_s, ">= from");
}

PacedReplay::PacedReplay(std::unique_ptr<ScanReader> reader, const ReplayOptions& options)
    : reader_(std::move(reader)), options_(options) {
  options_.validate();
  is_ahead_ = read(first_);
  if (is_ahead_) return;
  const std::string end = std::isfinite(options_.to_s) ? " to " + number_text(options_.to_s) + " s" : " on";
  throw InputError("the recording holds no scan from " + number_text(options_.from_s) + " s" + end +
                   " after its first one");
}

bool PacedReplay::read(LaserScan& scan) {
  while (!is_over_ && reader_->next(scan, {})) {
    if (!start_s_) start_s_ = scan.time_s;
    const double elapsed_s = scan.time_s - *start_s_;
    is_over_ = elapsed_s > options_.to_s;
    // Without a beginning nothing is left out, not even what is from before the first scan.
    const bool is_from_there_on = options_.from_s == 0.0 || elapsed_s >= options_.from_s;
    if (!is_over_ && is_from_there_on) return true;
  }
  is_over_ = true;
  return false;
}

bool PacedReplay::next(LaserScan& scan, Seconds /*timeout*/) {
  const bool is_there = take(scan);
  counts_.num_damaged_lines = reader_->counts().num_damaged_lines;
  counts_.num_other_lines = reader_->counts().num_other_lines;
  if (!is_there) return false;
  wait_for(scan.time_s);
  scan.index = counts_.num_scans++;
  return true;
}

bool PacedReplay::take(LaserScan& scan) {
  if (is_over_) return false;
  if (std::exchange(is_ahead_, false)) {
    scan = first_;
  } else {
    if (!read(spare_)) return false;
    scan = spare_;
  }
  return true;
}

void PacedReplay::wait_for(double time_s) {
  constexpr double kMostGap_s = 60.0;
  if (!options_.speed) return;
  if (counts_.num_scans == 0) {
    due_at_ = Clock::now();
  } else {
    const double gap_s = std::clamp(time_s - given_s_, 0.0, kMostGap_s) / *options_.speed;
    due_at_ += std::chrono::duration_cast<Clock::duration>(Seconds(std::min(gap_s, kMostGap_s)));
  }
  given_s_ = time_s;
  const Seconds left = due_at_ - Clock::now();
  if (left <= Seconds::zero()) return;
  const auto whole_s = static_cast<time_t>(left.count());
  const timespec wait = {whole_s, static_cast<long>((left.count() - static_cast<double>(whole_s)) * 1e9)};
  // Not sleep_for, which goes on sleeping after a signal.
  ::nanosleep(&wait, nullptr);
}

}  // namespace scanbed::hw
