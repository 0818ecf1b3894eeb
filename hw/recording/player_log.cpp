// SPDX-License-Identifier: MIT
#include "hw/recording/player_log.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "core/errors/input_error.hpp"
#include "core/geometry/angles.hpp"
#include "hw/recording/even_angles.hpp"
#include "hw/recording/field_reader.hpp"
#include "hw/recording/json_value.hpp"
#include "hw/recording/line_reader.hpp"

namespace scanbed::hw {
namespace {

/// What stands in front of each message.
struct Prefix {
  double time_s = 0.0;
  std::string_view interface;
  int index = 0;
  int type = 0;
  int subtype = 0;
};

Prefix read_prefix(FieldReader& fields) {
  Prefix prefix;
  prefix.time_s = fields.time("time");
  fields.word();  // host
  fields.word();  // robot
  prefix.interface = fields.word();
  prefix.index = fields.count("index");
  prefix.type = fields.count("type");
  prefix.subtype = fields.count("subtype");
  if (prefix.index >= kMostPlayerLasers) fields.fail("index is more than 999");
  return prefix;
}

bool is_scan(const Prefix& prefix) {
  return prefix.interface == "laser" && prefix.type == 1 && (prefix.subtype == 1 || prefix.subtype == 2);
}

ScanGeometry read_geometry_fields(FieldReader& fields) {
  ScanGeometry geometry;
  geometry.first_rad = fields.finite("min_angle");
  fields.finite("max_angle");
  geometry.step_rad = fields.finite("resolution");
  geometry.max_range_m = fields.finite("max_range");
  geometry.num_beams = fields.count("number of readings");
  if (!fields.ok()) return geometry;
  // Half a unit of the last of the format's digits; and Player computes in floats.
  restore_even_angles(geometry,
                      {.first_rad = 0.6e-4, .step_rad = 0.6e-8 + std::abs(geometry.step_rad) * 0x1p-23});
  return geometry;
}

double player_range_m(double reading_m, double max_range_m) {
  if (reading_m >= max_range_m) return kNoEcho;
  if (reading_m == 0.0) return kTooClose;
  return reading_m > 0.0 ? reading_m : kInvalid;
}

void read_pose_fields(FieldReader& fields, LaserScan& scan) {
  const double x_m = fields.finite("pose x");
  const double y_m = fields.finite("pose y");
  const double theta_rad = fields.finite("pose theta");
  if (fields.ok()) scan.X_OR = Pose2{{x_m, y_m}, wrap_to_pi(theta_rad)};
}

/// Reads the message itself. @throws InputError for what is wrong with it.
void read_message(FieldReader& fields, const Prefix& prefix, LaserScan& scan) {
  scan.time_s = prefix.time_s;
  scan.X_OR.reset();
  scan.range_m.clear();
  fields.word();  // id
  if (prefix.subtype == 2) read_pose_fields(fields, scan);
  scan.geometry = read_geometry_fields(fields);
  const std::int64_t num_fields = fields.num_left();
  if (fields.ok() && num_fields != 2 * std::int64_t{scan.geometry.num_beams}) {
    fields.fail(std::to_string(scan.geometry.num_beams) + " readings announced, but " +
                std::to_string(num_fields) + " fields left on the line, two a reading");
  }
  for (int i = 0; fields.ok() && i < scan.geometry.num_beams; ++i) {
    scan.range_m.push_back(player_range_m(fields.number("a reading"), scan.geometry.max_range_m));
    fields.word();  // intensity
  }
  if (!fields.ok()) throw InputError("laser: " + fields.failure());
  check_geometry(scan.geometry);
}

class PlayerSource final : public ScanSource {
 public:
  PlayerSource(std::unique_ptr<ByteStream> bytes, std::string name, std::string only, DamageReport report)
      : lines_(unpack(std::move(bytes))),
        name_(std::move(name)),
        only_(std::move(only)),
        report_(std::move(report)) {}

  bool read(RecordedScan& out) override {
    TextLine line;
    while (lines_.next(line)) {
      if (try_line(line, out)) return true;
    }
    need_clean_end(lines_.end(), name_, counts_.num_scans);
    return false;
  }

 private:
  /// Whether the line held a scan; what is wrong with a line is reported.
  bool try_line(const TextLine& line, RecordedScan& out) {
    try {
      if (line.is_too_long) throw InputError(LineReader::kTooLong);
      if (line.text.find('\0') != std::string_view::npos) throw InputError("holds zero bytes");
      return take_line(line.text, out);
    } catch (const InputError& error) {
      ++counts_.num_damaged_lines;
      if (report_) report_(name_ + ":" + std::to_string(line.number) + ": line skipped: " + error.what());
      return false;
    }
  }

  bool take_line(std::string_view text, RecordedScan& out) {
    if (FieldReader(text).word().empty()) return false;
    if (text.starts_with('#')) {
      ++counts_.num_other_lines;
      take_comment(text);
      return false;
    }
    FieldReader fields(text);
    const Prefix prefix = read_prefix(fields);
    if (!fields.ok()) throw InputError(fields.failure());
    const std::string device = "laser:" + std::to_string(prefix.index);
    const std::string source = source_of(prefix.index, device);
    const bool is_wanted = only_.empty() || only_ == device || only_ == source;
    if (!is_scan(prefix) || !is_wanted) {
      ++counts_.num_other_lines;
      if (is_scan(prefix)) left_out_.add(source.empty() ? device : source);
      return false;
    }
    read_message(fields, prefix, out.scan);
    out.scan.source = source;
    out.features.reset();
    out.truth.reset();
    ++counts_.num_scans;
    return true;
  }

  std::string source_of(int index, const std::string& device) const {
    const auto named = names_.find(index);
    if (named != names_.end()) return named->second;
    return index == 0 ? "" : device;
  }

  /// What our own writer leaves in comments: `## metadata {...}` and `## laser 1 {"name": ...}`.
  void take_comment(std::string_view text) {
    constexpr std::string_view kMetadata = "## metadata ";
    constexpr std::string_view kLaser = "## laser ";
    if (text.starts_with(kMetadata)) {
      const JsonValue json = parse_json(text.substr(kMetadata.size()));
      for (const auto& [key, value] : json.object("metadata")) metadata_[key] = value.text("metadata");
    } else if (text.starts_with(kLaser)) {
      FieldReader fields(text.substr(kLaser.size()));
      const int index = fields.count("index");
      if (!fields.ok() || index >= kMostPlayerLasers)
        throw InputError("a laser's index is no number up to 999");
      names_[index] = parse_json(text.substr(std::min(text.find('{'), text.size()))).at("name").text("name");
    }
  }

  LineReader lines_;
  std::string name_;
  std::string only_;
  DamageReport report_;
  std::map<int, std::string> names_;  // of lasers, by index
};

}  // namespace

std::unique_ptr<ScanSource> read_player_log(std::unique_ptr<ByteStream> bytes, std::string name,
                                            const PlayerOptions& options, DamageReport report) {
  return std::make_unique<PlayerSource>(std::move(bytes), std::move(name), options.only, std::move(report));
}

}  // namespace scanbed::hw
