// SPDX-License-Identifier: MIT
#include "core/track/tracker.hpp"

#include <algorithm>
#include <cmath>

#include "core/track/leg_circle.hpp"

namespace scanbed {
namespace {

constexpr double kMaxStep_s = 10.0;  // after a longer pause nothing is where it was

const TrackOptions& validated(const TrackOptions& options) {
  options.validate();
  return options;
}

}  // namespace

Tracker::Tracker(const TrackOptions& options) : options_(validated(options)), ego_motion_(options.motion) {}

void Tracker::set_options(const TrackOptions& options) {
  options_ = validated(options);
  ego_motion_.set_source(options.motion);
}

const std::vector<Track>& Tracker::update(const LaserScan& scan, const Features& features) {
  return update(scan, features, ego_motion_.update(scan));
}

const std::vector<Track>& Tracker::update(const LaserScan& scan, const Features& features,
                                          const Pose2& X_WS) {
  X_WS_ = X_WS;
  const TrackedScan now{scan, X_WS, step_s(scan.time_s)};
  people_.update(now, features.legs, options_);
  mark_legs(features);
  cylinders_.update(now, features.circles, circle_is_leg_, options_);
  reported_.clear();
  report(people_.tracks());
  report(cylinders_.tracks());
  std::sort(reported_.begin(), reported_.end(), [](const Track& a, const Track& b) { return a.id < b.id; });
  return reported_;
}

// Time since the last scan. A clock that jumps back, or says nothing, has not moved.
double Tracker::step_s(double time_s) {
  if (!std::isfinite(time_s)) return 0.0;
  const double step_s = has_begun_ ? std::clamp(time_s - last_time_s_, 0.0, kMaxStep_s) : 0.0;
  has_begun_ = true;
  last_time_s_ = time_s;
  return step_s;
}

void Tracker::mark_legs(const Features& features) {
  circle_is_leg_.clear();
  for (const Circle& circle : features.circles)
    circle_is_leg_.push_back(is_leg_too(circle, features.legs) ? 1 : 0);
}

void Tracker::report(std::vector<LiveTrack>& tracks) {
  for (LiveTrack& track : tracks) {
    if (!track.is_confirmed(options_) || track.num_missed > options_.num_coasted_scans) continue;
    if (track.kind != TrackKind::kCylinder && track.score(options_) < options_.min_score) continue;
    if (track.id == 0) track.id = ++last_id_;
    reported_.push_back(seen_from(X_WS_, track, options_));
  }
}

}  // namespace scanbed
