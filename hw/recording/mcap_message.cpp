// SPDX-License-Identifier: MIT
#include "hw/recording/mcap_message.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/errors/input_error.hpp"
#include "hw/recording/even_angles.hpp"
#include "hw/recording/json_text.hpp"
#include "hw/recording/json_value.hpp"
#include "hw/recording/nano_time.hpp"
#include "hw/recording/scan_json.hpp"

namespace scanbed::hw {
namespace {

void write_time(JsonText& json, double time_s) {
  const NanoTime time = to_nano_time(time_s);
  json.key("timestamp").begin_object().key("sec").integer(static_cast<std::int64_t>(time.sec));
  json.key("nsec").integer(time.nsec).end_object();
}

void write_no_turn(JsonText& json) {
  json.key("pose").begin_object().key("position").begin_object();
  json.key("x")
      .integer(0)
      .key("y")
      .integer(0)
      .key("z")
      .integer(0)
      .end_object()
      .key("orientation")
      .begin_object();
  json.key("x")
      .integer(0)
      .key("y")
      .integer(0)
      .key("z")
      .integer(0)
      .key("w")
      .integer(1)
      .end_object()
      .end_object();
}

template <class IsIn>
void write_beams(JsonText& json, std::string_view key, const LaserScan& scan, const IsIn& is_in) {
  json.key(key).begin_array();
  for (int beam = 0; beam < scan.num_beams(); ++beam) {
    if (is_in(scan.range_m[static_cast<std::size_t>(beam)])) json.integer(beam);
  }
  json.end_array();
}

void mark_beams(const JsonValue& json, std::string_view key, double value_m, LaserScan& scan) {
  for (const JsonValue& item : json.at(key).array(key)) {
    const int beam = item.integer(key);
    if (beam < 0 || beam >= scan.num_beams()) throw InputError("'" + std::string(key) + "' names no beam");
    scan.range_m[static_cast<std::size_t>(beam)] = value_m;
  }
}

void read_foreign_ranges(LaserScan& scan) {
  constexpr double kMostRange_m = 1e30;
  for (double& range_m : scan.range_m) {
    if (range_m <= 0.0 || range_m > kMostRange_m) range_m = kNoEcho;
  }
}

/// Of a LaserScan alone: first and last angle are all that it says.
ScanGeometry guess_geometry(const JsonValue& json, int num_beams) {
  constexpr double kRounding = 0x1p-22;  // as of those who compute in floats
  ScanGeometry geometry;
  geometry.num_beams = num_beams;
  geometry.first_rad = json.at("start_angle").number("start_angle");
  const double span_rad = json.at("end_angle").number("end_angle") - geometry.first_rad;
  if (num_beams > 1) geometry.step_rad = span_rad / (num_beams - 1);
  restore_even_angles(geometry, {.first_rad = kRounding * std::abs(geometry.first_rad),
                                 .step_rad = kRounding * std::abs(geometry.step_rad)});
  check_geometry(geometry);
  return geometry;
}

double read_timestamp(const JsonValue& json) {
  const JsonValue& time = json.at("timestamp");
  const double sec = time.at("sec").number("sec");
  const double nsec = time.at("nsec").number("nsec");
  if (sec >= 0.0 && is_time(sec) && nsec >= 0.0 && nsec < 1e9) return sec + nsec * 1e-9;
  throw InputError("'timestamp' is no time");
}

void read_beams(const JsonValue& json, LaserScan& scan) {
  scan.time_s = read_time(json);
  scan.source = json.at("source").text("source");
  scan.geometry = read_geometry(json.at("geometry"), scan.num_beams());
  if (const JsonValue* const odometry = json.find("odometry")) scan.X_OR = read_pose(*odometry);
  scan.health = read_health(json);
  mark_beams(json, "no_echo", kNoEcho, scan);
  mark_beams(json, "too_close", kTooClose, scan);
  mark_beams(json, "invalid", kInvalid, scan);
  const auto is_negative = [](double range_m) { return std::isfinite(range_m) && range_m < 0.0; };
  if (std::any_of(scan.range_m.begin(), scan.range_m.end(), is_negative))
    throw InputError("a range is negative");
}

}  // namespace

std::string encode_mcap_scan(const LaserScan& scan) {
  std::string out;
  JsonText json(out);
  json.begin_object();
  write_time(json, scan.time_s);
  json.key("frame_id").text("laser");
  write_no_turn(json);
  json.key("start_angle").number(scan.geometry.first_rad);
  json.key("end_angle").number(scan.geometry.bearing_rad(std::max(scan.num_beams() - 1, 0)));
  json.key("ranges").begin_array();
  for (const double range_m : scan.range_m) json.number(std::isfinite(range_m) ? range_m : 0.0);
  json.end_array().key("intensities").begin_array().end_array().end_object();
  return out;
}

std::string encode_mcap_beams(const LaserScan& scan) {
  std::string out;
  JsonText json(out);
  json.begin_object();
  write_time(json, scan.time_s);
  json.key("t_s").number(scan.time_s).key("source").text(scan.source).key("geometry");
  write_geometry(json, scan.geometry);
  if (scan.X_OR) {
    json.key("odometry");
    write_pose(json, *scan.X_OR);
  }
  write_health(json, scan.health);
  write_beams(json, "no_echo", scan, [](double range_m) { return range_m == kNoEcho; });
  write_beams(json, "too_close", scan, [](double range_m) { return range_m == kTooClose; });
  write_beams(json, "invalid", scan, [](double range_m) { return std::isnan(range_m); });
  json.end_object();
  return out;
}

std::string encode_mcap_features(const Features& features, double time_s) {
  std::string out;
  JsonText json(out);
  json.begin_object();
  write_time(json, time_s);
  json.key("features");
  write_features(json, features);
  json.end_object();
  return out;
}

std::string encode_mcap_truth(const Truth& truth, double time_s) {
  std::string out;
  JsonText json(out);
  json.begin_object();
  write_time(json, time_s);
  json.key("truth");
  write_truth(json, truth);
  json.end_object();
  return out;
}

void decode_mcap_scan(std::string_view scan_json, const McapSideMessages& side, RecordedScan& out) {
  const JsonValue json = parse_json(scan_json);
  LaserScan& scan = out.scan;
  scan.time_s = read_timestamp(json);
  scan.source.clear();
  scan.X_OR.reset();
  scan.health = {};
  scan.range_m.clear();
  for (const JsonValue& item : json.at("ranges").array("ranges"))
    scan.range_m.push_back(item.number("a range"));
  if (side.beams.empty()) {
    scan.geometry = guess_geometry(json, scan.num_beams());
    read_foreign_ranges(scan);
  } else {
    read_beams(parse_json(side.beams), scan);
  }
  out.features.reset();
  if (!side.features.empty()) {
    out.features = read_features(parse_json(side.features).at("features"), scan.num_beams());
  }
  out.truth.reset();
  if (!side.truth.empty()) out.truth = read_truth(parse_json(side.truth).at("truth"), scan.num_beams());
}

}  // namespace scanbed::hw
