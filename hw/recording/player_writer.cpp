// SPDX-License-Identifier: MIT
#include "hw/recording/player_writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "core/errors/input_error.hpp"
#include "hw/recording/json_text.hpp"
#include "hw/recording/player_log.hpp"
#include "hw/recording/reading_limit.hpp"
#include "hw/recording/text_fields.hpp"

namespace scanbed::hw {
namespace {

constexpr double kRangeResolution_m = 0.001;

/// As printf("%0*.*f") or with a plus sign, in front of a number of a prefix or a message.
void append_padded(std::string& out, const char* format, double value) {
  std::array<char, 400> text;
  out.append(text.data(), static_cast<std::size_t>(std::snprintf(text.data(), text.size(), format, value)));
}

/// "time host robot laser index type subtype"; host is 127.0.0.1 and robot Player's port, as readlog wants
/// them.
void append_prefix(std::string& out, double time_s, int index, std::string_view message) {
  append_padded(out, "%014.3f", time_s);
  out.append(" 16777343 6665 laser ");
  append_padded(out, "%02.0f", index);
  out.append(" ").append(message);
}

double to_reading_m(double range_m, double max_m) {
  if (std::isfinite(range_m)) return range_m;
  return range_m == kNoEcho ? max_m : 0.0;
}

void append_scan(std::string& out, const LaserScan& scan, std::int64_t id) {
  const ScanGeometry& geometry = scan.geometry;
  const double max_m = reading_limit_m(scan, kRangeResolution_m);
  append_padded(out, " %04.0f", static_cast<double>(id));
  if (scan.X_OR) {
    append_padded(out, " %+07.3f", scan.X_OR->p_m.x());
    append_padded(out, " %+07.3f", scan.X_OR->p_m.y());
    append_padded(out, " %+07.3f", scan.X_OR->theta_rad);
  }
  append_padded(out, " %+.4f", geometry.first_rad);
  append_padded(out, " %+.4f", geometry.bearing_rad(std::max(scan.num_beams() - 1, 0)));
  append_padded(out, " %+.8f", geometry.step_rad);
  append_padded(out, " %+.4f", max_m);
  append_padded(out, " %04.0f", scan.num_beams());
  for (const double range_m : scan.range_m) {
    append_fixed(out, to_reading_m(range_m, max_m), 3);
    out.append("  0");  // intensity
  }
  out.push_back('\n');
}

class PlayerWriter final : public ScanWriter {
 public:
  PlayerWriter(std::unique_ptr<ByteSink> sink, const RecordingMetadata& metadata) : sink_(std::move(sink)) {
    sink_->append("## Player version scanbed\n## File version 0.3.0\n");
    if (!metadata.empty()) sink_->append("## metadata " + metadata_text(metadata) + "\n");
  }

  void write(const ScanRecord& record) override {
    const LaserScan& scan = record.scan;
    std::string text;
    const int index = index_of(scan, text);
    append_prefix(text, scan.time_s, index, scan.X_OR ? "001 002" : "001 001");
    append_scan(text, scan, num_scans_++);
    sink_->append(text);
  }

  void finish() override { sink_->finish(); }

 private:
  /// The laser's index; one that is new is introduced by a comment, where it has a name, and its geometry.
  int index_of(const LaserScan& scan, std::string& text) {
    const auto [found, is_new] = indices_.try_emplace(scan.source, static_cast<int>(indices_.size()));
    if (!is_new) return found->second;
    if (found->second >= kMostPlayerLasers) throw InputError("a Player log holds no more than 1000 lasers");
    std::string name;
    JsonText(name).begin_object().key("name").text(scan.source).end_object();
    text.append("## laser " + std::to_string(found->second) + " " + name + "\n");
    append_prefix(text, scan.time_s, found->second, "004 001");
    text.append(" +0.000 +0.000 +0.000 +0.150 +0.150\n");
    return found->second;
  }

  std::unique_ptr<ByteSink> sink_;
  std::map<std::string, int> indices_;  // of lasers, by source
  std::int64_t num_scans_ = 0;
};

}  // namespace

std::unique_ptr<ScanWriter> write_player_log(std::unique_ptr<ByteSink> sink,
                                             const RecordingMetadata& metadata) {
  return std::make_unique<PlayerWriter>(std::move(sink), metadata);
}

}  // namespace scanbed::hw
