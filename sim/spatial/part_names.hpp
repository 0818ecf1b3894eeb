// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace scanbed::sim {

// Names of bodies and geoms in the MuJoCo model. The last component never comes from a scenario, so that no
// two ids, whatever they hold, give the same name.

inline constexpr const char* kRobotBody = "robot";
inline constexpr const char* kFloorGeom = "floor";
inline constexpr const char* kLaserFloorGeom = "laser_floor";

/// Geom of a solid: "solid/<id>/<n>"; n counts the walls of a chain, and is 0 for every other shape.
std::string solid_name(std::string_view id, int n);

/// Geom that the laser meets in place of wall n of a chain: "solid/<id>/<n>.sheet".
std::string sheet_name(std::string_view id, int n);

/// Body of a walker: "walker/<id>/<part>"; the parts are torso, left_foot, left_shank, left_thigh and the
/// same on the right.
std::string walker_name(std::string_view id, std::string_view part);

/// Body of a tow: "tow/<id>/<part>"; the parts are cylinder and walker_end; sites walker_end
/// and cylinder_end, tendon rope.
std::string tow_name(std::string_view id, std::string_view part);

}  // namespace scanbed::sim
