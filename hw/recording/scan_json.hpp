// SPDX-License-Identifier: MIT
#pragma once

#include "core/detect/features.hpp"
#include "core/geometry/pose2.hpp"
#include "core/scan/laser_scan.hpp"
#include "core/scan/scan_geometry.hpp"
#include "core/scan/truth.hpp"
#include "hw/recording/json_text.hpp"
#include "hw/recording/json_value.hpp"

namespace scanbed::hw {

// The parts of a scan as JSON, shared by the formats that are made of it. SI units; what is written reads
// back to the same bits. Readers throw InputError for what is missing or cannot be.

/// Key "t_s" of a scan; what is_time() refuses is not accepted.
double read_time(const JsonValue& scan);

/// {"first_rad": ..., "step_rad": ..., "min_range_m": ..., "max_range_m": ..., "rotations": 2, "rotation_s":
/// ..., "step_s": ...}; max_range_m is left out where it is infinite. The number of beams the ranges tell.
void write_geometry(JsonText& json, const ScanGeometry& geometry);
ScanGeometry read_geometry(const JsonValue& json, int num_beams);

/// [x_m, y_m, theta_rad]
void write_pose(JsonText& json, const Pose2& pose);
Pose2 read_pose(const JsonValue& json);

/// Key "health" of a scan, {"severity": 2, "polluted": 1, "implausible": 0}; left out where all is fine.
void write_health(JsonText& json, const SensorHealth& health);
SensorHealth read_health(const JsonValue& scan);

/// [{"type": "line", "first": 0, "last": 58, "left": [x, y], ...}, ...] with the keys that `scanbed detect`
/// prints, but not rounded; slope and bias are left out for a line along y. Lines, then circles, then legs.
void write_features(JsonText& json, const Features& features);
Features read_features(const JsonValue& json, int num_beams);

/// {"pose": [...], "beams": [{"object": 0, "range": ..., "incidence": ..., "mixed": 0}, ...], "objects":
/// [...]}. A beam that met nothing has object -1 and range -1.
void write_truth(JsonText& json, const Truth& truth);
Truth read_truth(const JsonValue& json, int num_beams);

}  // namespace scanbed::hw
