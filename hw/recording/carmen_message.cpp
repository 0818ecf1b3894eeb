// SPDX-License-Identifier: MIT
#include "hw/recording/carmen_message.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/errors/input_error.hpp"
#include "core/geometry/angles.hpp"
#include "hw/recording/field_reader.hpp"
#include "hw/recording/reading_limit.hpp"

namespace scanbed::hw {
namespace {

enum class Format { kOld, kRaw, kRobot };

struct MessageFormat {
  std::string_view name;
  Format format;
};

constexpr std::array kMessages = {
    MessageFormat{"FLASER", Format::kOld},        MessageFormat{"RLASER", Format::kOld},
    MessageFormat{"RAWLASER1", Format::kRaw},     MessageFormat{"RAWLASER2", Format::kRaw},
    MessageFormat{"RAWLASER3", Format::kRaw},     MessageFormat{"RAWLASER4", Format::kRaw},
    MessageFormat{"ROBOTLASER1", Format::kRobot}, MessageFormat{"ROBOTLASER2", Format::kRobot},
};

const MessageFormat* find_message(std::string_view name) {
  const auto* const found = std::find_if(kMessages.begin(), kMessages.end(),
                                         [&](const MessageFormat& m) { return m.name == name; });
  return found == kMessages.end() ? nullptr : found;
}

constexpr int kTail = 3;            // ipc_timestamp host logger_timestamp
constexpr int kOldPoses = 6;        // x y theta odom_x odom_y odom_theta
constexpr int kRobotState = 11;     // poses 6, velocities 2, safety distances 2, turn axis
constexpr int kOldRobotState = 10;  // no turn axis

/// Whether what is left is `num` fields, with or without the tail.
bool is_left(const FieldReader& fields, int num) {
  return fields.num_left() == num || fields.num_left() == num + kTail;
}

/// The configuration in front of the readings of the newer messages.
ScanGeometry read_geometry(FieldReader& fields) {
  ScanGeometry geometry;
  fields.finite("laser_type");
  geometry.first_rad = fields.finite("start_angle");
  const double field_of_view_rad = fields.finite("field_of_view");
  geometry.step_rad = fields.finite("angular_resolution");
  const double max_range_m = fields.number("maximum_range");
  if (max_range_m > 0.0) geometry.max_range_m = max_range_m;
  fields.number("accuracy");
  fields.number("remission_mode");
  geometry.num_beams = fields.count("num_readings");
  if (!fields.ok()) return geometry;
  const int num_steps = geometry.num_beams - 1;
  if (geometry.step_rad == 0.0 && num_steps > 0) geometry.step_rad = field_of_view_rad / num_steps;
  if (const std::string_view fault = fault_of(geometry); !fault.empty()) fields.fail(std::string(fault));
  return geometry;
}

double carmen_range_m(double reading_m, double no_return_m) {
  if (reading_m >= no_return_m) return kNoEcho;
  if (reading_m > 0.0) return reading_m;
  if (reading_m == 0.0 || reading_m == kTooClose) return kTooClose;
  return kInvalid;
}

/// Reads geometry.num_beams readings. The caller has made sure that so many fields are there.
void read_ranges(FieldReader& fields, const CarmenLogOptions& options, LaserScan& scan) {
  const double own_m = scan.geometry.max_range_m;
  const bool is_beyond_lms = std::isfinite(own_m) && own_m > kLastLmsCode_m;
  const double limit_m =
      std::min(options.no_return_m.value_or(is_beyond_lms ? own_m : kFirstLmsCode_m), own_m);
  scan.geometry.max_range_m = limit_m;
  scan.range_m.resize(static_cast<std::size_t>(scan.geometry.num_beams));
  for (double& range_m : scan.range_m) {
    range_m = carmen_range_m(fields.number("a reading"), limit_m);
    if (!fields.ok()) return;
  }
}

std::optional<Pose2> read_pose(FieldReader& fields) {
  const double x_m = fields.number("pose x");
  const double y_m = fields.number("pose y");
  const double theta_rad = fields.number("pose theta");
  if (!std::isfinite(x_m) || !std::isfinite(y_m) || !std::isfinite(theta_rad)) return std::nullopt;
  return Pose2{{x_m, y_m}, wrap_to_pi(theta_rad)};
}

/// Fails unless at least `num` fields are left: before storage is made for them.
void need_left(FieldReader& fields, int num_readings) {
  const int num_left = fields.num_left();
  if (!fields.ok() || num_left >= num_readings) return;
  fields.fail(std::to_string(num_readings) + " readings announced, but " + std::to_string(num_left) +
              " fields left on the line");
}

void fail_count(FieldReader& fields, const LaserScan& scan) {
  fields.fail("wrong number of fields: " + std::to_string(fields.num_left()) + " left after " +
              std::to_string(scan.geometry.num_beams) + " readings");
}

void read_old(FieldReader& fields, const CarmenLogOptions& options, LaserScan& scan) {
  scan.geometry = guess_carmen_geometry(fields.count("num_readings"));
  need_left(fields, scan.geometry.num_beams);
  if (!fields.ok()) return;
  read_ranges(fields, options, scan);
  if (!is_left(fields, kOldPoses)) fail_count(fields, scan);
  read_pose(fields);  // the laser's, which the log's maker has corrected or not
  scan.X_OR = read_pose(fields);
}

/// Steps over "num_remissions [remissions]" and leaves `num_after` fields or fails.
void skip_remissions(FieldReader& fields, int num_after, const LaserScan& scan) {
  const int num_remissions = fields.count("num_remissions");
  if (!fields.ok()) return;
  if (num_remissions > fields.num_left() || !is_left(fields, num_remissions + num_after)) {
    return fail_count(fields, scan);
  }
  for (int i = 0; i < num_remissions; ++i) fields.number("a remission");
}

/// Whether a ROBOTLASER line lacks the remissions and the turn axis, as those of older logs do. Such a line
/// has as many fields as a newer one that was cut off after its time: only the host's name tells them apart.
bool is_without_remissions(const FieldReader& fields) {
  if (fields.num_left() != kOldRobotState + kTail) return false;
  FieldReader ahead(fields);
  for (int i = 0; i < kOldRobotState + 1; ++i) ahead.word();
  ahead.number("host");
  return !ahead.ok();
}

void read_robot_state(FieldReader& fields, LaserScan& scan) {
  const bool is_old = is_without_remissions(fields);
  if (!is_old) skip_remissions(fields, kRobotState, scan);
  if (!fields.ok()) return;
  read_pose(fields);  // the laser's
  scan.X_OR = read_pose(fields);
  const int num_more = (is_old ? kOldRobotState : kRobotState) - 6;
  for (int i = 0; i < num_more; ++i) fields.number("robot state");
}

void read_new(FieldReader& fields, const MessageFormat& message, const CarmenLogOptions& options,
              LaserScan& scan) {
  scan.geometry = read_geometry(fields);
  need_left(fields, scan.geometry.num_beams);
  if (!fields.ok()) return;
  read_ranges(fields, options, scan);
  if (!fields.ok()) return;
  if (message.format == Format::kRaw) {
    skip_remissions(fields, 0, scan);
  } else {
    read_robot_state(fields, scan);
  }
}

/// Reads the tail, if there is one; whether there is.
bool read_time(FieldReader& fields, LaserScan& scan) {
  if (!fields.ok() || fields.num_left() == 0) return false;
  scan.time_s = fields.time("ipc_timestamp");
  fields.word();  // host
  fields.number("logger_timestamp");
  return fields.ok();
}

CarmenLine damaged(std::string what) {
  return {.kind = CarmenLine::Kind::kDamaged, .has_time = false, .damage = std::move(what)};
}

}  // namespace

bool is_carmen_message(std::string_view name) {
  return find_message(name) != nullptr;
}

ScanGeometry guess_carmen_geometry(int num_beams) {
  ScanGeometry geometry;
  geometry.num_beams = num_beams;
  if (num_beams == 180 || num_beams == 181) {
    geometry.step_rad = radians(1.0);
  } else if (num_beams == 400 || num_beams == 401) {
    geometry.first_rad = radians(-50.0);
    geometry.step_rad = radians(0.25);
  } else if (num_beams != 360 && num_beams > 1) {
    geometry.step_rad = kPi / (num_beams - 1);
  }
  return geometry;
}

void CarmenLogOptions::validate() const {
  require(!no_return_m || *no_return_m > 0.0, "log.no_return_m", no_return_m.value_or(0.0), "> 0");
  if (only.empty() || find_message(only) != nullptr) return;
  std::string allowed;
  for (const MessageFormat& message : kMessages) allowed += " " + std::string(message.name);
  throw InputError("log.only: '" + only + "' is no laser message; allowed:" + allowed);
}

CarmenLine parse_carmen_line(std::string_view line, const CarmenLogOptions& options, LaserScan& scan) {
  if (line.find('\0') != std::string_view::npos) return damaged("holds zero bytes");
  FieldReader fields(line);
  const std::string_view name = fields.word();
  if (name.empty()) return {};
  const MessageFormat* const message = find_message(name);
  if (message == nullptr || (!options.only.empty() && name != options.only)) {
    return {.kind = CarmenLine::Kind::kOther, .has_time = false, .damage = {}};
  }
  scan.source = name;
  scan.X_OR.reset();
  if (message->format == Format::kOld) {
    read_old(fields, options, scan);
  } else {
    read_new(fields, *message, options, scan);
  }
  const bool has_time = read_time(fields, scan);
  if (!fields.ok()) return damaged(std::string(name) + ": " + fields.failure());
  return {.kind = CarmenLine::Kind::kScan, .has_time = has_time, .damage = {}};
}

}  // namespace scanbed::hw
