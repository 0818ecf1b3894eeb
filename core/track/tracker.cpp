// SPDX-License-Identifier: MIT
#include "core/track/tracker.hpp"

#include <algorithm>
#include <cmath>

#include "core/track/leg_circle.hpp"

namespace scanbed {
namespace {

constexpr double kMinThinRadius_m = 0.03;
constexpr double kMaxThinRadius_m = 0.11;
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
  gather_legs(features);
  people_.update(now, legs_, options_);
  mark_legs(features);
  cylinders_.update(now, features.circles, circle_is_leg_, options_);
  reported_.clear();
  report(people_.tracks());
  people_.spread_ids();
  hide_unreported(static_cast<int>(features.legs.size()));
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

// A leg whose width or depth misses the rules of legs is often a good circle all the same.
void Tracker::gather_legs(const Features& features) {
  legs_.assign(features.legs.begin(), features.legs.end());
  legs_.insert(legs_.end(), features.doubtful_legs.begin(), features.doubtful_legs.end());
  if (options_.thin_circle_score == 0.0) return;
  const auto num_found = static_cast<std::ptrdiff_t>(legs_.size());
  for (const Circle& circle : features.circles) {
    const bool is_thin = circle.radius_m >= kMinThinRadius_m && circle.radius_m <= kMaxThinRadius_m;
    const bool is_known = std::any_of(legs_.begin(), legs_.begin() + num_found, [&](const Leg& leg) {
      return leg.beams.first <= circle.beams.last && circle.beams.first <= leg.beams.last;
    });
    if (!is_thin || is_known) continue;
    legs_.push_back({circle.beams, circle.center_m, options_.thin_circle_score});
  }
}

// Those that are doubtful, or were found as circles alone, are in no list that users know.
void Tracker::hide_unreported(int num_legs) {
  for (Track& track : reported_) {
    if (track.feature >= num_legs) track.feature = kNoFeature;
    if (track.second_feature >= num_legs) track.second_feature = kNoFeature;
  }
}

void Tracker::report(std::vector<LiveTrack>& tracks) {
  for (LiveTrack& track : tracks) {
    if (!track.is_shown(options_)) continue;
    if (track.id == 0) track.id = ++last_id_;
    reported_.push_back(seen_from(X_WS_, track));
  }
}

}  // namespace scanbed
