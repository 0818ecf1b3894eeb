// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/features.hpp"
#include "core/track/assignment.hpp"
#include "core/track/live_track.hpp"

namespace scanbed {

/// Follows circles: columns, bench feet, a pulled cylinder. One-to-one by place and radius.
class CylinderTracker {
 public:
  /// @param is_leg  of each circle: it is somebody's leg, and not followed.
  void update(const TrackedScan& now, const std::vector<Circle>& circles, const std::vector<char>& is_leg,
              const TrackOptions& options);

  std::vector<LiveTrack>& tracks() { return tracks_; }

 private:
  void assign(const std::vector<Circle>& circles, const TrackOptions& options);
  void begin_tracks(const TrackedScan& now, const std::vector<Circle>& circles, const TrackOptions& options);

  std::vector<LiveTrack> tracks_;
  std::vector<Eigen::Vector2d> p_WC_m_;  ///< this scan's circles in the world
  std::vector<char> is_open_;            ///< of each circle: may still be given to a track
  Assignment assignment_;
};

}  // namespace scanbed
