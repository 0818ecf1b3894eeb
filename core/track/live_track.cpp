// SPDX-License-Identifier: MIT
#include "core/track/live_track.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed {
namespace {

constexpr double kMaxLogOdds = 4.0;
constexpr double kMissLogOdds = -2.0;   // of looking at an empty place
constexpr double kMaxEmpty_s = 0.4;     // a place looked through so long has lost its track
constexpr double kMaxOccupied_s = 1.0;  // likewise where something stands that is not recognised
// Who has walked is somebody, also when standing. A single leg that stands may be furniture that a track has
// slipped on to.
constexpr double kTwoLegsMemory_s = 20.0;
constexpr double kOneLegMemory_s = 4.0;
constexpr double kMaxUnrecognised_s = 0.5;  // what stands where somebody stood is taken for them so long
constexpr double kMaxDoubt_m = 0.28;        // standard deviation of a place beyond which it says nothing
constexpr double kLegReach_m = 0.4;         // of a leg from the person's middle
constexpr int kMinLegEchoes = 2;
constexpr double kMinSettled_s = 0.7;
constexpr double kMaxSettled_m = 0.08;

double sigmoid(double x) {
  return 1.0 / (1.0 + std::exp(-x));
}

}  // namespace

double log_odds_of(double score) {
  if (!(score > 0.0)) return -kMaxLogOdds;
  if (score >= 1.0) return kMaxLogOdds;
  return std::clamp(std::log(score / (1.0 - score)), -kMaxLogOdds, kMaxLogOdds);
}

bool LiveTrack::is_confirmed(const TrackOptions& options) const {
  const bool is_sure = second_feature != kNoFeature && log_odds >= log_odds_of(options.sure_score);
  return num_hits >= options.num_confirming_hits || is_sure;
}

double LiveTrack::gate_m(const TrackOptions& options) const {
  return std::min(options.max_gate_m, options.gate_m + options.gate_speed_m_per_s * unseen_s);
}

void LiveTrack::predict(const TrackedScan& now, double accel_psd_m2_per_s3) {
  point.predict(now.dt_s, accel_psd_m2_per_s3);
  age_s += now.dt_s;
  unseen_s += now.dt_s;
  motion_evidence *=
      std::exp(-now.dt_s / (second_feature != kNoFeature ? kTwoLegsMemory_s : kOneLegMemory_s));
  feature = kNoFeature;
  second_feature = kNoFeature;
}

void LiveTrack::count_hit(double feature_log_odds, const TrackedScan& now, const TrackOptions& options) {
  const double keep_ratio = num_hits == 0 ? 0.0 : options.evidence_keep_ratio;
  log_odds = keep_ratio * log_odds + (1.0 - keep_ratio) * feature_log_odds;
  ++num_hits;
  num_missed = 0;
  unseen_s = 0.0;
  hidden_s = occupied_s = empty_s = 0.0;
  history.add(now.scan.time_s, point.p_m, options.displacement_window_s);
  const double displacement = history.net_displacement_m() / options.displacement_step_m;
  motion_evidence = std::max(motion_evidence, std::min(displacement, options.max_displacement_evidence));
  if (history.net_displacement_m() >= options.mobile_distance_m) is_mobile = true;
}

PlaceView LiveTrack::view_of_place(const TrackedScan& now, double size_m) const {
  const Eigen::Vector2d p_ST_m = now.X_WS.inverse() * point.p_m;
  const PlaceView middle = view_of(now.scan, p_ST_m, size_m);
  if (kind != TrackKind::kPerson || middle != PlaceView::kEmpty) return middle;
  // Beams pass between a person's legs.
  return num_echoes_near(now.scan, p_ST_m, kLegReach_m) >= kMinLegEchoes ? PlaceView::kOccupied : middle;
}

void LiveTrack::count_miss(const TrackedScan& now, double size_m, const TrackOptions& options) {
  ++num_missed;
  view = view_of_place(now, size_m);
  (view == PlaceView::kHidden ? hidden_s : view == PlaceView::kOccupied ? occupied_s : empty_s) += now.dt_s;
  if (view == PlaceView::kEmpty) {
    log_odds = options.evidence_keep_ratio * log_odds + (1.0 - options.evidence_keep_ratio) * kMissLogOdds;
  }
  // What stands where a cylinder stood is most likely still that cylinder.
  const bool has_stood = kind == TrackKind::kCylinder && !is_mobile;
  const double max_occupied_s = has_stood ? options.max_hidden_s : kMaxOccupied_s;
  const bool is_gone = empty_s > kMaxEmpty_s || occupied_s > max_occupied_s;
  is_dead = hidden_s > options.max_hidden_s ||
            (num_missed > options.num_coasted_scans && (is_gone || !is_confirmed(options)));
}

bool LiveTrack::is_at_hand(const TrackOptions& options) const {
  if (num_missed == 0) return true;
  if (kind == TrackKind::kCylinder) return num_missed <= options.num_coasted_scans;
  if (view == PlaceView::kEmpty || point.var_p_m2 > kMaxDoubt_m * kMaxDoubt_m) return false;
  const bool stands_there = unseen_s <= kMaxUnrecognised_s && hidden_s + empty_s == 0.0;
  return num_missed <= options.num_coasted_scans || (kind == TrackKind::kPerson && stands_there);
}

bool LiveTrack::is_shown(const TrackOptions& options) const {
  if (!is_confirmed(options) || !is_at_hand(options)) return false;
  return kind == TrackKind::kCylinder || score() >= options.min_score;
}

bool LiveTrack::is_settled() const {
  return !is_mobile && history.span_s() >= kMinSettled_s && history.net_displacement_m() <= kMaxSettled_m;
}

double LiveTrack::evidence() const {
  return log_odds + motion_evidence;
}

double LiveTrack::score() const {
  return sigmoid(evidence());
}

std::uint64_t with_legs(std::uint64_t recent_legs, int feature, int second_feature) {
  constexpr std::uint64_t kBase = 1u << 10;  // six digits: two for each of three scans
  const auto digit = [](int leg) { return static_cast<std::uint64_t>(leg + 1) % kBase; };
  constexpr std::uint64_t kSixDigits = (std::uint64_t{1} << 60) - 1;
  return ((recent_legs * kBase + digit(feature)) * kBase + digit(second_feature)) & kSixDigits;
}

Track seen_from(const Pose2& X_WS, const LiveTrack& track) {
  const Pose2 X_SW = X_WS.inverse();
  Track seen;
  seen.id = track.id;
  seen.kind = track.kind;
  seen.position_m = X_SW * track.point.p_m;
  seen.velocity_m_per_s = X_SW.rotate(track.point.v_m_per_s);
  seen.radius_m = track.radius_m;
  seen.score = track.score();
  seen.is_mobile = track.is_mobile;
  seen.is_settled = track.is_settled();
  seen.feature = track.feature;
  seen.second_feature = track.second_feature;
  return seen;
}

}  // namespace scanbed
