// SPDX-License-Identifier: MIT
#include "core/track/cylinder_tracker.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed {
namespace {

constexpr double kAccel_m2_per_s3 = 0.5;
constexpr double kSigma_m = 0.03;                    // of a circle's centre
constexpr double kCylinderStartSpeed_m_per_s = 0.7;  // standard deviation of what is not known yet
constexpr double kRadiusGate_m = 0.10;               // circles of so different a radius are not the same
constexpr double kRadiusGain = 0.1;                  // share of a new radius in the track's

// Who is hidden may turn: by how much what moves may be off from going straight on.
double hidden_way_m(const LiveTrack& track) {
  return track.is_mobile ? track.point.v_m_per_s.norm() * track.hidden_s : 0.0;
}

}  // namespace

void CylinderTracker::update(const TrackedScan& now, const std::vector<Circle>& circles,
                             const std::vector<char>& is_leg, const TrackOptions& options) {
  p_WC_m_.clear();
  is_open_.clear();
  for (std::size_t i = 0; i < circles.size(); ++i) {
    p_WC_m_.push_back(now.X_WS * circles[i].center_m);
    const bool fits = circles[i].radius_m >= options.min_cylinder_radius_m &&
                      circles[i].radius_m <= options.max_cylinder_radius_m;
    is_open_.push_back(fits && is_leg[i] == 0 ? 1 : 0);
  }
  for (LiveTrack& track : tracks_) track.predict(now, kAccel_m2_per_s3);
  assign(circles, options);
  for (LiveTrack& track : tracks_) {
    if (track.feature == kNoFeature) {
      track.count_miss(now, track.radius_m, options);
      // Of what has not been seen to move, a speed is noise: it is expected where it was.
      if (!track.is_mobile) track.point.v_m_per_s.setZero();
      continue;
    }
    const Circle& circle = circles[track.feature];
    track.point.correct(p_WC_m_[track.feature], kSigma_m);
    track.radius_m += kRadiusGain * (circle.radius_m - track.radius_m);
    track.count_hit(log_odds_of(circle.score), now, options);
  }
  begin_tracks(now, circles, options);
  std::erase_if(tracks_, [](const LiveTrack& track) { return track.is_dead; });
}

void CylinderTracker::assign(const std::vector<Circle>& circles, const TrackOptions& options) {
  const int num_circles = static_cast<int>(circles.size());
  const int num_tracks = static_cast<int>(tracks_.size());
  assignment_.reset(num_circles, num_tracks, 1.0);
  for (int row = 0; row < num_circles; ++row) {
    if (is_open_[row] == 0) continue;
    for (int column = 0; column < num_tracks; ++column) {
      const LiveTrack& track = tracks_[column];
      const double gate_m = track.gate_m(options) + hidden_way_m(track);
      const double off = (p_WC_m_[row] - track.point.p_m).squaredNorm() / (gate_m * gate_m);
      const double off_radius = (circles[row].radius_m - track.radius_m) / kRadiusGate_m;
      assignment_.allow(row, column, off + off_radius * off_radius);
    }
  }
  const std::span<const int> track_of_circle = assignment_.solve();
  for (int row = 0; row < num_circles; ++row) {
    if (track_of_circle[row] == kUnassigned) continue;
    tracks_[track_of_circle[row]].feature = row;
    is_open_[row] = 0;
  }
}

void CylinderTracker::begin_tracks(const TrackedScan& now, const std::vector<Circle>& circles,
                                   const TrackOptions& options) {
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (is_open_[i] == 0) continue;
    LiveTrack track;
    track.kind = TrackKind::kCylinder;
    track.point.p_m = p_WC_m_[i];
    track.point.var_p_m2 = kSigma_m * kSigma_m;
    track.point.var_v_m2_per_s2 = kCylinderStartSpeed_m_per_s * kCylinderStartSpeed_m_per_s;
    track.radius_m = circles[i].radius_m;
    track.feature = static_cast<int>(i);
    track.count_hit(log_odds_of(circles[i].score), now, options);
    tracks_.push_back(track);
  }
}

}  // namespace scanbed
