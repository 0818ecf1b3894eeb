// SPDX-License-Identifier: MIT
#include "hw/recording/carmen_log.hpp"

#include <utility>

#include "core/errors/input_error.hpp"
#include "hw/recording/field_reader.hpp"
#include "hw/recording/left_out_sources.hpp"
#include "hw/recording/line_reader.hpp"
#include "hw/serial/stop_signal.hpp"

namespace scanbed::hw {

struct CarmenLog::Impl {
  std::string name;
  CarmenLogOptions options;
  Report report;
  LineReader lines;
  CarmenLogCounts counts;
  LeftOutSources left_out;
  LaserScan scan;         // read last; the next one to give where is_ahead
  ScanGeometry geometry;  // of the last scan; that of `scan` may be a damaged line's
  bool is_ahead = false;  // the first scan is read before it is asked for
  double time_s = 0.0;    // of the last scan that had one

  bool read_scan();
  CarmenLine read_line(const TextLine& line);
  void leave_out(const TextLine& line);
};

CarmenLine CarmenLog::Impl::read_line(const TextLine& line) {
  if (!line.is_too_long) return parse_carmen_line(line.text, options, scan);
  return {.kind = CarmenLine::Kind::kDamaged, .has_time = false, .damage = LineReader::kTooLong};
}

void CarmenLog::Impl::leave_out(const TextLine& line) {
  const std::string_view message = FieldReader(line.text).word();
  if (is_carmen_message(message)) left_out.add(message);
}

/// Reads the next scan into `scan`; false at the end.
bool CarmenLog::Impl::read_scan() {
  TextLine line;
  while (lines.next(line)) {
    const CarmenLine read = read_line(line);
    switch (read.kind) {
      case CarmenLine::Kind::kBlank:
        break;
      case CarmenLine::Kind::kOther:
        ++counts.num_other_lines;
        if (counts.num_scans == 0) leave_out(line);
        break;
      case CarmenLine::Kind::kDamaged:
        ++counts.num_damaged_lines;
        if (report) report(name + ":" + std::to_string(line.number) + ": line skipped: " + read.damage);
        break;
      case CarmenLine::Kind::kScan:
        if (read.has_time) time_s = scan.time_s;
        scan.time_s = time_s;
        scan.index = counts.num_scans++;
        geometry = scan.geometry;
        return true;
    }
  }
  need_clean_end(lines.end(), name, counts.num_scans);
  return false;
}

CarmenLog::CarmenLog(const std::filesystem::path& path, const CarmenLogOptions& options, Report report)
    : CarmenLog(open_file(path), path.string(), options, std::move(report)) {}

CarmenLog::CarmenLog(std::unique_ptr<ByteStream> bytes, std::string name, const CarmenLogOptions& options,
                     Report report)
    : impl_(new Impl{.name = std::move(name),
                     .options = options,
                     .report = std::move(report),
                     .lines = LineReader(unpack(std::move(bytes))),
                     .counts = {},
                     .left_out = {},
                     .scan = {}}) {
  options.validate();
  impl_->is_ahead = impl_->read_scan();
  if (impl_->is_ahead) return;
  if (options.is_guess && impl_->left_out.text(options.only).empty()) {
    throw InputError(
        impl_->name +
        ": is no recording that is known; known are CARMEN and Player logs, ROS 1 bags, MCAP and "
        "JSON Lines");
  }
  throw InputError(impl_->name + ": holds no scan of a CARMEN log" + impl_->left_out.text(options.only) +
                   " (" + std::to_string(impl_->counts.num_damaged_lines) + " damaged lines, " +
                   std::to_string(impl_->counts.num_other_lines) + " others)");
}

CarmenLog::~CarmenLog() = default;

const ScanGeometry& CarmenLog::geometry() const {
  return impl_->geometry;
}

bool CarmenLog::next(LaserScan& scan, Seconds /*timeout*/) {
  try {
    if (!std::exchange(impl_->is_ahead, false) && !impl_->read_scan()) return false;
  } catch (const Stopped&) {
    return false;
  }
  scan = impl_->scan;
  return true;
}

const CarmenLogCounts& CarmenLog::counts() const {
  return impl_->counts;
}

const RecordingMetadata& CarmenLog::metadata() const {
  static const RecordingMetadata kNone;
  return kNone;
}

}  // namespace scanbed::hw
