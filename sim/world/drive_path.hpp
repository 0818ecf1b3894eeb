// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "sim/world/world.hpp"

namespace scanbed::sim {

/// A robot's motion at constant speed, ahead and about itself: a straight line, an arc, a turn on the spot.
struct Motion {
  double duration_s = 0.0;
  double speed_m_per_s = 0.0;
  double turn_rad_per_s = 0.0;

  /// Where it leads in `time_s` from X_WR; also behind its duration.
  Pose2 pose_behind(const Pose2& X_WR, double time_s) const;
};

/// One after the other: how a robot that stands at `X_WR` drives along a path.
///
/// @pre the path validates.
std::vector<Motion> motions_along(const FollowPath& path, const Pose2& X_WR, const Robot& robot);

/// @throws InputError, its message beginning with `name`, where the path has no point, one out of reach, two
///         equal neighbours, too many rounds, or a bad radius.
void validate_path(const FollowPath& path, std::string_view name);

}  // namespace scanbed::sim
