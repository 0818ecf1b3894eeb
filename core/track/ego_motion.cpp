// SPDX-License-Identifier: MIT
#include "core/track/ego_motion.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed {
namespace {

constexpr double kReferenceDistance_m = 0.3;
constexpr double kReferenceTurn_rad = 0.2;
constexpr double kReferenceRatio = 0.75;  // explained by the reference: with less, it is time for a new one
constexpr double kDoubtfulRatio = 0.6;
constexpr double kMaxStep_m = 1000.0;  // of odometry from scan to scan: beyond is a fault

bool is_finite(const Pose2& pose) {
  return pose.p_m.allFinite() && std::isfinite(pose.theta_rad);
}

Pose2 scaled(const Pose2& step, double factor) {
  return {factor * step.p_m, factor * step.theta_rad};
}

}  // namespace

// Motion of the robot since the last scan, by its odometry; none where it has none, or where it says what
// cannot be.
Pose2 EgoMotion::odometry_step(const LaserScan& scan) {
  if (scan.X_OR && !is_finite(*scan.X_OR)) return {};
  Pose2 step;
  if (scan.X_OR && last_X_OR_) step = last_X_OR_->inverse() * *scan.X_OR;
  last_X_OR_ = scan.X_OR;
  if (!is_finite(step) || step.p_m.norm() > kMaxStep_m) return {};
  // A field that always holds the same pose is what recordings without odometry have.
  if (step.p_m.norm() > 1e-6 || std::abs(step.theta_rad) > 1e-6) odometry_moves_ = true;
  return step;
}

const Pose2& EgoMotion::update(const LaserScan& scan) {
  const Pose2 by_odometry = odometry_step(scan);
  const double dt_s = has_begun_ ? scan.time_s - last_time_s_ : 0.0;
  last_time_s_ = scan.time_s;
  if (source_ == MotionSource::kStill) return X_WS_;
  if (source_ == MotionSource::kOdometry) return X_WS_ = X_WS_ * by_odometry;
  projector_.project(scan, points_);
  if (!has_begun_) {
    has_begun_ = true;
    begin_reference(scan);
    return X_WS_;
  }
  const bool use_odometry = source_ == MotionSource::kAuto && odometry_moves_;
  const double growth = last_dt_s_ > 0.0 && dt_s > 0.0 ? std::min(2.0, dt_s / last_dt_s_) : 1.0;
  const Pose2 before = X_WS_;
  const bool is_trusted = match(scan, X_WS_ * (use_odometry ? by_odometry : scaled(last_step_, growth)));
  last_step_ = scaled(before.inverse() * X_WS_, is_trusted ? 1.0 : 0.5);
  last_dt_s_ = dt_s;
  return X_WS_;
}

bool EgoMotion::match(const LaserScan& scan, const Pose2& expected_X_WS) {
  ScanMatch match = matcher_.match(points_, X_WA_.inverse() * expected_X_WS);
  if (match.explained_ratio < kDoubtfulRatio) {  // it may have stopped
    const ScanMatch standing = matcher_.match(points_, X_WA_.inverse() * X_WS_);
    if (standing.explained_ratio > match.explained_ratio) match = standing;
  }
  X_WS_ = X_WA_ * match.X_AB;
  const bool is_far =
      match.X_AB.p_m.norm() > kReferenceDistance_m || std::abs(match.X_AB.theta_rad) > kReferenceTurn_rad;
  if (is_far || match.explained_ratio < kReferenceRatio) begin_reference(scan);
  return match.is_trusted;
}

void EgoMotion::begin_reference(const LaserScan& scan) {
  matcher_.set_reference(points_, scan.geometry);
  X_WA_ = X_WS_;
}

}  // namespace scanbed
