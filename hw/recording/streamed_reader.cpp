// SPDX-License-Identifier: MIT
#include "hw/recording/streamed_reader.hpp"

#include <limits>
#include <utility>

#include "core/errors/input_error.hpp"
#include "hw/serial/stop_signal.hpp"

namespace scanbed::hw {

StreamedReader::StreamedReader(std::unique_ptr<ScanSource> source, const std::string& name,
                               const RecordingOptions& options)
    : source_(std::move(source)),
      no_return_m_(options.no_return_m.value_or(std::numeric_limits<double>::infinity())) {
  is_ahead_ = read();
  if (is_ahead_) return;
  throw InputError(name + ": holds no scan" + source_->left_out().text(options.only) + " (" +
                   std::to_string(counts_.num_damaged_lines) + " damaged, " +
                   std::to_string(counts_.num_other_lines) + " other lines or records)");
}

bool StreamedReader::read() {
  if (is_over_) return false;
  // Until the source says otherwise: after a failure there is nothing to read either.
  is_over_ = true;
  const std::int64_t num_scans = counts_.num_scans;
  const auto take_counts = [&](bool is_there) {
    counts_ = source_->counts();
    counts_.num_scans = num_scans + static_cast<std::int64_t>(is_there);
  };
  bool is_there = false;
  try {
    is_there = source_->read(spare_);
  } catch (...) {
    take_counts(false);  // what was skipped before the failure counts too
    throw;
  }
  take_counts(is_there);
  if (!is_there) return false;
  std::swap(given_, spare_);
  given_.scan.index = num_scans;
  for (double& range_m : given_.scan.range_m) {
    if (range_m >= no_return_m_) range_m = kNoEcho;
  }
  is_over_ = false;
  return true;
}

bool StreamedReader::next(LaserScan& scan, Seconds /*timeout*/) {
  try {
    if (!std::exchange(is_ahead_, false) && !read()) return false;
  } catch (const Stopped&) {
    return false;
  }
  scan = given_.scan;
  return true;
}

const Truth* StreamedReader::truth() const {
  return !is_ahead_ && given_.truth ? &*given_.truth : nullptr;
}

const Features* StreamedReader::features() const {
  return !is_ahead_ && given_.features ? &*given_.features : nullptr;
}

}  // namespace scanbed::hw
