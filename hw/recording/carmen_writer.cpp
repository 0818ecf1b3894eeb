// SPDX-License-Identifier: MIT
#include "hw/recording/carmen_writer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/errors/input_error.hpp"
#include "hw/recording/carmen_message.hpp"
#include "hw/recording/reading_limit.hpp"
#include "hw/recording/text_fields.hpp"

namespace scanbed::hw {
namespace {

bool starts_with_any(std::string_view text, std::string_view first, std::string_view second) {
  return text.starts_with(first) || text.starts_with(second);
}

/// Whether the message that the source names is an older one, which has neither angles nor a maximum range,
/// and can hold the scan: readings up to the LMS's codes are ranges.
bool fits_old_message(const LaserScan& scan) {
  return is_carmen_message(scan.source) && starts_with_any(scan.source, "FLASER", "RLASER") &&
         guess_carmen_geometry(scan.num_beams()) == scan.geometry &&
         scan.geometry.max_range_m >= kFirstLmsCode_m;
}

/// The maximum range to write. One within the LMS's codes would turn ranges there into "no return".
double limit_m_of(const LaserScan& scan) {
  const double limit_m = reading_limit_m(scan, 0.0);
  const bool is_in_codes = limit_m > kFirstLmsCode_m && limit_m <= kLastLmsCode_m;
  const bool reaches_codes = std::any_of(scan.range_m.begin(), scan.range_m.end(), [](double range_m) {
    return std::isfinite(range_m) && range_m >= kFirstLmsCode_m;
  });
  return is_in_codes && reaches_codes ? kLastLmsCode_m + 0.01 : limit_m;
}

void append_readings(std::string& out, const LaserScan& scan, double no_return_m) {
  append_field(out, scan.num_beams());
  for (const double range_m : scan.range_m) {
    append_field(out, range_m == kNoEcho ? no_return_m : range_m == kTooClose ? 0.0 : range_m);
  }
}

void append_pose(std::string& out, const std::optional<Pose2>& pose) {
  append_field(out, pose ? pose->p_m.x() : kInvalid);
  append_field(out, pose ? pose->p_m.y() : kInvalid);
  append_field(out, pose ? pose->theta_rad : kInvalid);
}

void append_configuration(std::string& out, const LaserScan& scan, double limit_m) {
  const ScanGeometry& geometry = scan.geometry;
  append_field(out, 0);  // laser_type
  append_field(out, geometry.first_rad);
  append_field(out, geometry.step_rad * std::max(scan.num_beams() - 1, 0));
  append_field(out, geometry.step_rad);
  append_field(out, limit_m);
  append_field(out, 0.001);  // accuracy
  append_field(out, 0);      // remission_mode
}

std::string line_of(const LaserScan& scan, std::string line) {
  const bool is_old = starts_with_any(line, "FLASER", "RLASER");
  const bool is_robot = line.starts_with("ROBOT");
  const double limit_m = is_old ? kFirstLmsCode_m : limit_m_of(scan);
  if (!is_old) append_configuration(line, scan, limit_m);
  append_readings(line, scan, std::max(limit_m, kLastLmsCode_m));
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

  void write(const ScanRecord& record) override {
    sink_->append(line_of(record.scan, message_of(record.scan)));
  }
  void finish() override { sink_->finish(); }

 private:
  /// The scan's own message where it can hold the scan, else the first that no other laser has.
  std::string message_of(const LaserScan& scan) {
    if (fits_old_message(scan)) return scan.source;
    const std::string kind = scan.X_OR ? "ROBOTLASER" : "RAWLASER";
    const auto [message, is_new] = messages_.try_emplace({kind, scan.source});
    if (is_new) message->second = free_message(kind, scan.source);
    return message->second;
  }

  std::string free_message(const std::string& kind, const std::string& source) const {
    const auto is_free = [&](const std::string& message) {
      return is_carmen_message(message) && std::none_of(messages_.begin(), messages_.end(),
                                                        [&](const auto& m) { return m.second == message; });
    };
    if (source.starts_with(kind) && is_free(source)) return source;
    for (int number = 1; is_carmen_message(kind + std::to_string(number)); ++number) {
      if (is_free(kind + std::to_string(number))) return kind + std::to_string(number);
    }
    throw InputError("a CARMEN log has no more messages " + kind + " for laser '" + source +
                     "'; choose some lasers with ?only=");
  }

  std::unique_ptr<ByteSink> sink_;
  std::map<std::pair<std::string, std::string>, std::string> messages_;  // of kind and source
};

}  // namespace

std::unique_ptr<ScanWriter> write_carmen_log(std::unique_ptr<ByteSink> sink,
                                             const RecordingMetadata& metadata) {
  return std::make_unique<CarmenWriter>(std::move(sink), metadata);
}

}  // namespace scanbed::hw
