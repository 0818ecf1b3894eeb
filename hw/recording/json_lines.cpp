// SPDX-License-Identifier: MIT
#include "hw/recording/json_lines.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "core/errors/input_error.hpp"
#include "hw/recording/json_text.hpp"
#include "hw/recording/json_value.hpp"
#include "hw/recording/line_reader.hpp"
#include "hw/recording/scan_json.hpp"

namespace scanbed::hw {
namespace {

constexpr int kVersion = 1;

void write_range(JsonText& json, double range_m) {
  if (std::isfinite(range_m)) {
    json.number(range_m);
  } else if (std::isnan(range_m)) {
    json.text("nan");
  } else {
    json.text(range_m > 0.0 ? "inf" : "-inf");
  }
}

double read_range(const JsonValue& json) {
  if (const double* const range_m = json.if_number()) {
    if (*range_m >= 0.0) return *range_m;
    throw InputError("a range is negative");
  }
  const std::string& text = json.text("a range");
  if (text == "inf") return kNoEcho;
  if (text == "-inf") return kTooClose;
  if (text == "nan") return kInvalid;
  throw InputError("a range is a text other than inf, -inf and nan");
}

void write_scan(JsonText& json, const ScanRecord& record) {
  const LaserScan& scan = record.scan;
  json.begin_object().key("scan").integer(scan.index).key("t_s").number(scan.time_s);
  json.key("source").text(scan.source).key("geometry");
  write_geometry(json, scan.geometry);
  if (scan.X_OR) {
    json.key("odometry");
    write_pose(json, *scan.X_OR);
  }
  write_health(json, scan.health);
  json.key("ranges").begin_array();
  for (const double range_m : scan.range_m) write_range(json, range_m);
  json.end_array();
  if (record.features != nullptr) {
    json.key("features");
    write_features(json, *record.features);
  }
  if (record.truth != nullptr) {
    json.key("truth");
    write_truth(json, *record.truth);
  }
  json.end_object();
}

void read_scan(const JsonValue& json, RecordedScan& out) {
  LaserScan& scan = out.scan;
  scan.time_s = read_time(json);
  scan.source = json.at("source").text("source");
  scan.range_m.clear();
  for (const JsonValue& item : json.at("ranges").array("ranges")) scan.range_m.push_back(read_range(item));
  scan.geometry = read_geometry(json.at("geometry"), scan.num_beams());
  scan.health = read_health(json);
  const JsonValue* const odometry = json.find("odometry");
  const JsonValue* const features = json.find("features");
  const JsonValue* const truth = json.find("truth");
  scan.X_OR = odometry == nullptr ? std::nullopt : std::optional(read_pose(*odometry));
  out.features =
      features == nullptr ? std::nullopt : std::optional(read_features(*features, scan.num_beams()));
  out.truth = truth == nullptr ? std::nullopt : std::optional(read_truth(*truth, scan.num_beams()));
}

class JsonLinesWriter final : public ScanWriter {
 public:
  JsonLinesWriter(std::unique_ptr<ByteSink> sink, const RecordingMetadata& metadata)
      : sink_(std::move(sink)) {
    JsonText json(line_);
    json.begin_object().key("format").text(kJsonLinesFormat).key("version").integer(kVersion);
    json.key("metadata").begin_object();
    for (const auto& [key, value] : metadata) json.key(key).text(value);
    json.end_object().end_object();
    put_line();
  }

  void write(const ScanRecord& record) override {
    JsonText json(line_);
    write_scan(json, record);
    put_line();
  }

  void finish() override {
    line_ = R"({"end":1})";
    put_line();
    sink_->finish();
  }

 private:
  void put_line() {
    line_.push_back('\n');
    sink_->append(line_);
    line_.clear();
  }

  std::unique_ptr<ByteSink> sink_;
  std::string line_;
};

class JsonLinesSource final : public ScanSource {
 public:
  JsonLinesSource(std::unique_ptr<ByteStream> bytes, std::string name, std::string only, DamageReport report)
      : lines_(unpack(std::move(bytes))),
        name_(std::move(name)),
        only_(std::move(only)),
        report_(std::move(report)) {
    read_header();
  }

  bool read(RecordedScan& out) override {
    TextLine line;
    while (!has_ended_ && lines_.next(line)) {
      if (line.text.empty()) continue;
      if (try_line(line, out)) return true;
    }
    if (has_ended_) skip_rest();
    need_clean_end(lines_.end(), name_, counts_.num_scans);
    if (has_ended_) return false;
    throw InputError(name_ + ": is not finished: it ends after " + std::to_string(counts_.num_scans) +
                     " scans without an end line (cut off, or its recorder was killed)");
  }

 private:
  void read_header() {
    TextLine line;
    if (!lines_.next(line)) {
      need_clean_end(lines_.end(), name_, 0);
      throw InputError(name_ + ": is no recording of scanbed: it has no first line");
    }
    try {
      take_header(parse_json(line.text));
    } catch (const InputError& error) {
      throw InputError(name_ + ":1: " + error.what());
    }
  }

  void take_header(const JsonValue& header) {
    const JsonValue* const format = header.find("format");
    const std::string* const format_name = format == nullptr ? nullptr : format->if_text();
    if (format_name == nullptr || *format_name != kJsonLinesFormat) {
      throw InputError("is not the first line of a recording of scanbed");
    }
    const int version = header.at("version").integer("version");
    if (version != kVersion) {
      throw InputError("version is " + std::to_string(version) + ", known is " + std::to_string(kVersion));
    }
    for (const auto& [key, value] : header.at("metadata").object("metadata")) {
      metadata_[key] = value.text("metadata");
    }
  }

  /// Reads on behind the end line: compressed data tells of damage only at its own end.
  void skip_rest() {
    bool is_told = false;
    for (TextLine line; lines_.next(line);) {
      if (line.text.empty() || std::exchange(is_told, true)) continue;
      damaged(line, "stands behind the end line, as all that follows does");
    }
  }

  void damaged(const TextLine& line, const std::string& what) {
    ++counts_.num_damaged_lines;
    if (report_) report_(name_ + ":" + std::to_string(line.number) + ": line skipped: " + what);
  }

  /// Whether the line held a scan; what is wrong with a line is reported.
  bool try_line(const TextLine& line, RecordedScan& out) {
    try {
      if (line.is_too_long) throw InputError(LineReader::kTooLong);
      const JsonValue json = parse_json(line.text);
      if (json.find("ranges") != nullptr) {
        read_scan(json, out);
        // As in bags and MCAP, the laser without a name is called "scan".
        const std::string source = out.scan.source.empty() ? "scan" : out.scan.source;
        if (!only_.empty() && source != only_) {
          ++counts_.num_other_lines;
          left_out_.add(source);
          return false;
        }
        ++counts_.num_scans;
        return true;
      }
      has_ended_ = json.find("end") != nullptr;
      if (!has_ended_) ++counts_.num_other_lines;
    } catch (const InputError& error) {
      damaged(line, error.what());
    }
    return false;
  }

  LineReader lines_;
  std::string name_;
  std::string only_;
  DamageReport report_;
  bool has_ended_ = false;
};

}  // namespace

std::unique_ptr<ScanWriter> write_json_lines(std::unique_ptr<ByteSink> sink,
                                             const RecordingMetadata& metadata) {
  return std::make_unique<JsonLinesWriter>(std::move(sink), metadata);
}

std::unique_ptr<ScanSource> read_json_lines(std::unique_ptr<ByteStream> bytes, std::string name,
                                            const JsonLinesOptions& options, DamageReport report) {
  return std::make_unique<JsonLinesSource>(std::move(bytes), std::move(name), options.only,
                                           std::move(report));
}

}  // namespace scanbed::hw
