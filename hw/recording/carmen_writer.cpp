// SPDX-License-Identifier: MIT
#include "hw/recording/carmen_writer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "hw/recording/carmen_message.hpp"
#include "hw/recording/reading_limit.hpp"
#include "hw/recording/text_fields.hpp"

namespace scanbed::hw {
namespace {

bool starts_with_any(std::string_view text, std::string_view first, std::string_view second) {
  return text.starts_with(first) || text.starts_with(second);
}

/// The scan's own message where it can hold the scan.
std::string message_of(const LaserScan& scan) {
  const bool is_known = is_carmen_message(scan.source);
  if (is_known && starts_with_any(scan.source, "FLASER", "RLASER")) {
    // It has no maximum range, either: readings up to the LMS's codes are ranges.
    const bool is_as_guessed = guess_carmen_geometry(scan.num_beams()) == scan.geometry;
    if (is_as_guessed && scan.geometry.max_range_m >= CarmenLogOptions().no_return_m) return scan.source;
  }
  if (scan.X_OR) return is_known && scan.source.starts_with("ROBOT") ? scan.source : "ROBOTLASER1";
  return is_known && scan.source.starts_with("RAW") ? scan.source : "RAWLASER1";
}

double to_reading_m(double range_m) {
  if (std::isfinite(range_m) || std::isnan(range_m)) return range_m;
  return range_m > 0.0 ? kNoReturnReading_m : 0.0;
}

void append_readings(std::string& out, const LaserScan& scan) {
  append_field(out, scan.num_beams());
  for (const double range_m : scan.range_m) append_field(out, to_reading_m(range_m));
}

void append_pose(std::string& out, const std::optional<Pose2>& pose) {
  append_field(out, pose ? pose->p_m.x() : kInvalid);
  append_field(out, pose ? pose->p_m.y() : kInvalid);
  append_field(out, pose ? pose->theta_rad : kInvalid);
}

void append_configuration(std::string& out, const LaserScan& scan) {
  const ScanGeometry& geometry = scan.geometry;
  append_field(out, 0);  // laser_type
  append_field(out, geometry.first_rad);
  append_field(out, geometry.step_rad * std::max(scan.num_beams() - 1, 0));
  append_field(out, geometry.step_rad);
  append_field(out, reading_limit_m(scan, 0.0));
  append_field(out, 0.001);  // accuracy
  append_field(out, 0);      // remission_mode
}

std::string line_of(const LaserScan& scan) {
  std::string line = message_of(scan);
  const bool is_old = starts_with_any(line, "FLASER", "RLASER");
  const bool is_robot = line.starts_with("ROBOT");
  if (!is_old) append_configuration(line, scan);
  append_readings(line, scan);
  if (!is_old) append_field(line, 0);  // num_remissions
  if (is_old || is_robot) {
    append_pose(line, scan.X_OR);  // the laser's; where it is mounted is not known
    append_pose(line, scan.X_OR);
  }
  if (is_robot) line.append(" 0 0 0 0 0");  // velocities, safety distances, turn axis
  append_field(line, scan.time_s);
  append_field(line, std::string_view("scanbed"));
  append_field(line, scan.time_s);
  return line + "\n";
}

class CarmenWriter final : public ScanWriter {
 public:
  CarmenWriter(std::unique_ptr<ByteSink> sink, const RecordingMetadata& metadata) : sink_(std::move(sink)) {
    sink_->append(
        "# CARMEN Logfile\n# message_name [message contents] ipc_timestamp ipc_hostname logger_timestamp\n");
    if (!metadata.empty()) sink_->append("# metadata " + metadata_text(metadata) + "\n");
  }

  void write(const ScanRecord& record) override { sink_->append(line_of(record.scan)); }
  void finish() override { sink_->finish(); }

 private:
  std::unique_ptr<ByteSink> sink_;
};

}  // namespace

std::unique_ptr<ScanWriter> write_carmen_log(std::unique_ptr<ByteSink> sink,
                                             const RecordingMetadata& metadata) {
  return std::make_unique<CarmenWriter>(std::move(sink), metadata);
}

}  // namespace scanbed::hw
