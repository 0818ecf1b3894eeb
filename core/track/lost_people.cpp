// SPDX-License-Identifier: MIT
#include "core/track/lost_people.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanbed {
namespace {

constexpr double kTurn_s = 2.0;           // in which who is out of sight loses direction
constexpr double kNewcomerReach_m = 0.5;  // of a newcomer from where the other one is expected ...
constexpr double kHurry_m_per_s = 1.8;    // ... and more by this, for each second since
constexpr double kMaxTogether_s = 0.5;    // a leg may have begun a track of its own so long before the end

}  // namespace

double surprise_of(const LiveTrack& newcomer, const LiveTrack& missing) {
  const double off_m = (newcomer.point.p_m - missing.point.p_m).norm();
  const bool was_there_before = newcomer.age_s > missing.unseen_s + kMaxTogether_s;
  if (was_there_before || off_m > kNewcomerReach_m + kHurry_m_per_s * missing.unseen_s)
    return std::numeric_limits<double>::infinity();
  const double var_m2 = missing.point.var_p_m2;
  return off_m * off_m / var_m2 + 2.0 * std::log(var_m2);
}

void take_over(LiveTrack& newcomer, const LiveTrack& missing, const TrackOptions& options) {
  const double keep_ratio = options.evidence_keep_ratio;
  newcomer.kind = TrackKind::kPerson;
  newcomer.id = missing.id;
  newcomer.birth = missing.birth;
  newcomer.num_hits += missing.num_hits;
  newcomer.log_odds = keep_ratio * missing.log_odds + (1.0 - keep_ratio) * newcomer.log_odds;
  newcomer.motion_evidence = std::max(newcomer.motion_evidence, missing.motion_evidence);
  newcomer.is_mobile = true;
}

void lose_way(MovingPoint& point, double dt_s) {
  point.v_m_per_s *= std::exp(-dt_s / kTurn_s);
}

void LostPeople::remember(const LiveTrack& track) {
  if (track.kind != TrackKind::kPerson || track.id == 0 || !track.is_mobile) return;
  people_.push_back(track);
  people_.back().is_dead = false;
}

void LostPeople::predict(const TrackedScan& now, double accel_psd_m2_per_s3, const TrackOptions& options) {
  for (LiveTrack& lost : people_) {
    lost.point.predict(now.dt_s, accel_psd_m2_per_s3);
    lose_way(lost.point, now.dt_s);
    lost.unseen_s += now.dt_s;
    if (lost.unseen_s > options.max_lost_s) lost.is_dead = true;
  }
  bury_dead();
}

void LostPeople::bury_dead() {
  std::erase_if(people_, [](const LiveTrack& lost) { return lost.is_dead; });
}

}  // namespace scanbed
