// SPDX-License-Identifier: MIT
#include "hw/recording/ros_messages.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include "core/errors/input_error.hpp"
#include "core/geometry/angles.hpp"
#include "hw/recording/even_angles.hpp"
#include "hw/recording/little_endian.hpp"
#include "hw/recording/nano_time.hpp"

namespace scanbed::hw {

const RosType kLaserScanType = {
    "sensor_msgs/LaserScan", "90c7ef2dc6895d81024acba2ac42f369",
    "Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\nfloat32 time_increment\n"
    "float32 scan_time\nfloat32 range_min\nfloat32 range_max\nfloat32[] ranges\nfloat32[] intensities\n"
    "================================================================================\n"
    "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n"};

const RosType kTransformType = {
    "tf2_msgs/TFMessage", "94810edda583a504dfda3829e70d7eec",
    "geometry_msgs/TransformStamped[] transforms\n"
    "================================================================================\n"
    "MSG: geometry_msgs/TransformStamped\nHeader header\nstring child_frame_id\nTransform transform\n"
    "================================================================================\n"
    "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n"
    "================================================================================\n"
    "MSG: geometry_msgs/Transform\nVector3 translation\nQuaternion rotation\n"
    "================================================================================\n"
    "MSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n"
    "================================================================================\n"
    "MSG: geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"};

namespace {

void append_text(std::string& out, std::string_view text) {
  append_number(out, static_cast<std::uint32_t>(text.size()));
  out.append(text);
}

void append_header(std::string& out, std::uint32_t sequence, double time_s, std::string_view frame) {
  const NanoTime time = to_nano_time(time_s);
  append_number(out, sequence);
  append_number(out, static_cast<std::uint32_t>(time.sec));
  append_number(out, time.nsec);
  append_text(out, frame);
}

/// The time of a header; its frame goes to `frame`.
double read_header(ByteCursor& cursor, std::string_view& frame) {
  cursor.number<std::uint32_t>();
  const auto sec = cursor.number<std::uint32_t>();
  const auto nsec = cursor.number<std::uint32_t>();
  frame = cursor.piece();
  return to_seconds({sec, nsec});
}

void append_double(std::string& out, double value) {
  append_number(out, std::bit_cast<std::uint64_t>(value));
}

double read_double(ByteCursor& cursor) {
  return std::bit_cast<double>(cursor.number<std::uint64_t>());
}

float to_float(double value) {
  return static_cast<float>(value);
}

double to_range_m(float reading_m, const ScanGeometry& geometry) {
  const double range_m = shortest_decimal(reading_m);
  if (std::isnan(range_m)) return kInvalid;
  if (range_m > geometry.max_range_m) return kNoEcho;
  if (range_m < geometry.min_range_m || range_m < 0.0) return kTooClose;
  return range_m;
}

/// The fields between header and ranges.
ScanGeometry read_limits(ByteCursor& cursor) {
  ScanGeometry geometry;
  const float first_rad = cursor.float32();
  cursor.float32();  // angle_max follows from the others
  const float step_rad = cursor.float32();
  geometry.first_rad = first_rad;
  geometry.step_rad = step_rad;
  // A float's last digit, and a digit more for those who computed in floats.
  constexpr double kDigit = 0x1p-23;
  restore_even_angles(geometry,
                      {.first_rad = std::abs(first_rad) * kDigit, .step_rad = std::abs(step_rad) * kDigit});
  const double time_step_s = shortest_decimal(cursor.float32());
  const double scan_time_s = shortest_decimal(cursor.float32());
  if (std::isfinite(time_step_s)) geometry.timing.step_s = time_step_s;
  if (std::isfinite(scan_time_s)) geometry.timing.rotation_s = scan_time_s;
  geometry.min_range_m = shortest_decimal(cursor.float32());
  geometry.max_range_m = shortest_decimal(cursor.float32());
  return geometry;
}

Pose2 read_transform(ByteCursor& cursor) {
  Pose2 pose;
  pose.p_m.x() = read_double(cursor);
  pose.p_m.y() = read_double(cursor);
  read_double(cursor);
  const double x = read_double(cursor);
  const double y = read_double(cursor);
  const double z = read_double(cursor);
  const double w = read_double(cursor);
  pose.theta_rad = std::atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z));
  return pose;
}

}  // namespace

std::string encode_laser_scan(const LaserScan& scan, std::uint32_t sequence) {
  const ScanGeometry& geometry = scan.geometry;
  const bool is_interlaced = geometry.timing.num_rotations > 1;
  std::string out;
  append_header(out, sequence, scan.time_s, "laser");
  append_float(out, to_float(geometry.first_rad));
  append_float(out, to_float(geometry.bearing_rad(std::max(scan.num_beams() - 1, 0))));
  append_float(out, to_float(geometry.step_rad));
  append_float(out, is_interlaced ? 0.0F : to_float(geometry.timing.step_s));
  append_float(out, to_float(geometry.timing.num_rotations * geometry.timing.rotation_s));
  append_float(out, to_float(geometry.min_range_m));
  append_float(out, to_float(geometry.max_range_m));
  append_number(out, static_cast<std::uint32_t>(scan.range_m.size()));
  for (const double range_m : scan.range_m) append_float(out, to_float(range_m));
  append_number(out, std::uint32_t{0});
  return out;
}

void decode_laser_scan(std::string_view bytes, LaserScan& scan) {
  ByteCursor cursor(bytes);
  std::string_view frame;
  scan.time_s = read_header(cursor, frame);
  scan.geometry = read_limits(cursor);
  const auto num_beams = cursor.number<std::uint32_t>();
  ByteCursor readings(cursor.take(std::uint64_t{4} * num_beams));
  const auto num_intensities = cursor.number<std::uint32_t>();
  cursor.take(std::uint64_t{4} * num_intensities);
  if (!cursor.ok() || cursor.num_left() != 0) {
    throw InputError("a LaserScan of " + std::to_string(bytes.size()) + " bytes says it has " +
                     std::to_string(num_beams) + " ranges");
  }
  scan.geometry.num_beams = static_cast<int>(num_beams);
  check_geometry(scan.geometry);
  scan.X_OR.reset();
  scan.range_m.clear();
  for (std::uint32_t i = 0; i < num_beams; ++i) {
    scan.range_m.push_back(to_range_m(readings.float32(), scan.geometry));
  }
}

std::string encode_odometry(const Pose2& X_OR, double time_s) {
  std::string out;
  append_number(out, std::uint32_t{1});
  append_header(out, 0, time_s, "odom");
  append_text(out, "base_link");
  append_double(out, X_OR.p_m.x());
  append_double(out, X_OR.p_m.y());
  append_double(out, 0.0);
  append_double(out, 0.0);
  append_double(out, 0.0);
  append_double(out, std::sin(X_OR.theta_rad / 2.0));
  append_double(out, std::cos(X_OR.theta_rad / 2.0));
  return out;
}

std::optional<Pose2> decode_odometry(std::string_view bytes) {
  ByteCursor cursor(bytes);
  std::optional<Pose2> found;
  const auto num_transforms = cursor.number<std::uint32_t>();
  for (std::uint32_t i = 0; i < num_transforms && cursor.ok(); ++i) {
    std::string_view parent;
    read_header(cursor, parent);
    std::string_view child = cursor.piece();
    const Pose2 pose = read_transform(cursor);
    for (std::string_view* frame : {&parent, &child}) {
      if (frame->starts_with('/')) frame->remove_prefix(1);
    }
    const bool is_odometry = parent == "odom" && (child == "base_link" || child == "base_footprint");
    if (is_odometry && pose.p_m.allFinite() && std::isfinite(pose.theta_rad)) found = pose;
  }
  return cursor.ok() ? found : std::nullopt;
}

}  // namespace scanbed::hw
