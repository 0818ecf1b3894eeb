// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/geometry/pose2.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed::hw {

/// A kind of ROS 1 message: what a connection says of itself. The sum is the MD5 of the definition.
struct RosType {
  std::string_view name;
  std::string_view md5;
  std::string_view definition;
};
extern const RosType kLaserScanType;                                   ///< sensor_msgs/LaserScan
extern const RosType kTransformType;                                   ///< tf2_msgs/TFMessage
inline constexpr std::string_view kOldTransformName = "tf/tfMessage";  ///< the same message, as it was called

// LaserScan holds float32: ranges in decimal steps (millimetres, centimetres) and evenly divided angles come
// back to the bit (see even_angles.hpp), others to 7 digits. It has one time step between beams, so that the
// timing of interlaced scans is lost; odometry is another message; intensities are not read.

/// @param sequence  of the message's header, counts from 0.
/// @throws InputError where the time does not fit (see to_nano_time).
std::string encode_laser_scan(const LaserScan& scan, std::uint32_t sequence);

/// All of a scan but its index, source and odometry. Ranges below range_min are kTooClose, above range_max
/// kNoEcho.
/// @throws InputError where the bytes are no such message or the geometry cannot be.
void decode_laser_scan(std::string_view bytes, LaserScan& scan);

/// X_OR as a transform from "odom" to "base_link".
std::string encode_odometry(const Pose2& X_OR, double time_s);

/// The last transform from "odom" to "base_link" or "base_footprint", seen from above; nothing where the
/// message has none, or is none.
std::optional<Pose2> decode_odometry(std::string_view bytes);

}  // namespace scanbed::hw
