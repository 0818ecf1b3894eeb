// SPDX-License-Identifier: MIT
#include "core/track/scan_matcher.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/angles.hpp"
#include "core/geometry/line_fit.hpp"

namespace scanbed {
namespace {

constexpr int kNormalNeighbours = 3;  // to either side
constexpr double kMaxNeighbourDistance_m = 0.3;
constexpr double kMaxNormalResidual_m = 0.03;  // of the neighbours: rougher surfaces have no tangent
constexpr double kResidualSigma_m = 0.02;
constexpr double kExpectedSigma_m = 0.3;
constexpr double kExpectedSigma_rad = 0.2;
constexpr double kExplained_m = 0.06;
constexpr double kMinExplainedRatio = 0.5;
constexpr int kMinJudged = 20;
constexpr double kGoodRatio = 0.85;  // with less, other turns are tried
constexpr double kConverged = 3e-4;  // m and rad
constexpr int kMaxLastRounds = 6;
constexpr int kTurns = 8;  // tried to either side
constexpr double kTurnStep_rad = 0.06;
constexpr int kWideWindow = 12;
constexpr int kNarrowWindow = 4;
constexpr int kNone = -1;

// Point i turned into A's axes.
Eigen::Vector2d turned(const Eigen::Vector2d& heading, const Points& points, int i) {
  return {heading.x() * points.x_m[i] - heading.y() * points.y_m[i],
          heading.y() * points.x_m[i] + heading.x() * points.y_m[i]};
}

// Of the change of a pose: weighted squares of distances from surfaces, and of what departs from the
// expected.
class NormalEquations {
 public:
  struct Row {
    double x, y, theta;  // how the distance changes with the pose
  };

  void add(const Row& row, double distance_m, double weight) {
    const double wx = weight * row.x;
    const double wy = weight * row.y;
    const double wt = weight * row.theta;
    xx_ += wx * row.x;
    xy_ += wx * row.y;
    xt_ += wx * row.theta;
    yy_ += wy * row.y;
    yt_ += wy * row.theta;
    tt_ += wt * row.theta;
    x_ -= wx * distance_m;
    y_ -= wy * distance_m;
    t_ -= wt * distance_m;
  }

  Pose2 solve(const Pose2& X_AB, const Pose2& expected_X_AB) const {
    const auto squared = [](double x) { return x * x; };
    const double by_m = squared(kResidualSigma_m / kExpectedSigma_m);
    const double by_rad = squared(kResidualSigma_m / kExpectedSigma_rad);
    const Eigen::Vector2d off_m = expected_X_AB.p_m - X_AB.p_m;
    const double off_rad = wrap_to_pi(expected_X_AB.theta_rad - X_AB.theta_rad);
    Eigen::Matrix3d matrix;
    matrix << xx_ + by_m, xy_, xt_, xy_, yy_ + by_m, yt_, xt_, yt_, tt_ + by_rad;
    const Eigen::Vector3d side(x_ + by_m * off_m.x(), y_ + by_m * off_m.y(), t_ + by_rad * off_rad);
    const Eigen::Vector3d change = matrix.ldlt().solve(side);
    return {X_AB.p_m + change.head<2>(), wrap_to_pi(X_AB.theta_rad + change.z())};
  }

 private:
  double xx_ = 0.0, xy_ = 0.0, xt_ = 0.0, yy_ = 0.0, yt_ = 0.0, tt_ = 0.0;
  double x_ = 0.0, y_ = 0.0, t_ = 0.0;
};

}  // namespace

void ScanMatcher::set_reference(const Points& points_A, const ScanGeometry& geometry) {
  reference_.clear();
  const bool has_directions = std::isfinite(geometry.first_rad) && std::abs(geometry.step_rad) > 0.0;
  if (geometry.num_beams < 1 || !has_directions) return;
  reference_.x_m.assign(points_A.x_m.begin(), points_A.x_m.end());
  reference_.y_m.assign(points_A.y_m.begin(), points_A.y_m.end());
  reference_.beam.assign(points_A.beam.begin(), points_A.beam.end());
  geometry_ = geometry;
  place_of_beam_.assign(std::max(0, geometry.num_beams), -1);
  int place = -1;
  for (int beam = 0; beam < geometry.num_beams; ++beam) {
    if (place + 1 < reference_.size() && reference_.beam[place + 1] == beam) ++place;
    place_of_beam_[beam] = place;
  }
  find_normals();
}

void ScanMatcher::find_normals() {
  const int num_points = reference_.size();
  nx_.assign(num_points, 0.0);
  ny_.assign(num_points, 0.0);
  for (int i = 0; i < num_points; ++i) {
    const Eigen::Vector2d p_m = reference_[i];
    LineMoments moments;
    const int last = std::min(num_points - 1, i + kNormalNeighbours);
    for (int k = std::max(0, i - kNormalNeighbours); k <= last; ++k) {
      if ((reference_[k] - p_m).squaredNorm() > kMaxNeighbourDistance_m * kMaxNeighbourDistance_m) continue;
      moments.add(reference_.x_m[k] - p_m.x(), reference_.y_m[k] - p_m.y());
    }
    if (moments.num_points < 3.0) continue;
    const LineFit line = fit_line(moments);
    if (line.distance_m(Eigen::Vector2d::Zero()) > kMaxNormalResidual_m) continue;
    nx_[i] = -line.direction.y();
    ny_[i] = line.direction.x();
  }
}

// The beam of A that points there, or one past the last.
int ScanMatcher::beam_of(const Eigen::Vector2d& p_AP) const {
  const double beam = geometry_.beam_towards(std::atan2(p_AP.y(), p_AP.x())) + 0.5;
  const bool is_in_view = beam >= 0.0 && beam < geometry_.num_beams;  // neither holds of what is no number
  return is_in_view ? static_cast<int>(beam) : geometry_.num_beams;
}

int ScanMatcher::place_of(const Eigen::Vector2d& p_AP) const {
  return place_of_beam_[std::min(beam_of(p_AP), geometry_.num_beams - 1)];
}

int ScanMatcher::nearest(const Eigen::Vector2d& p_AP, const Search& search) const {
  double least_m2 = search.gate_m * search.gate_m;
  int nearest = kNone;
  const int last = std::min(reference_.size() - 1, search.middle + search.window);
  for (int k = std::max(0, search.middle - search.window); k <= last; ++k) {
    const double dx_m = p_AP.x() - reference_.x_m[k];
    const double dy_m = p_AP.y() - reference_.y_m[k];
    const double distance_m2 = dx_m * dx_m + dy_m * dy_m;
    if (distance_m2 >= least_m2) continue;
    least_m2 = distance_m2;
    nearest = k;
  }
  return nearest;
}

// Of a point from A's surface at a place, signed along the normal there.
double ScanMatcher::distance_m(const Eigen::Vector2d& p_AP, int place) const {
  return nx_[place] * (p_AP.x() - reference_.x_m[place]) + ny_[place] * (p_AP.y() - reference_.y_m[place]);
}

// One Gauss-Newton step on all points that have a surface near, together with what was expected.
Pose2 ScanMatcher::step(const Points& points_B, const Pose2& X_AB, const Pose2& expected_X_AB,
                        const Round& round) {
  NormalEquations equations;
  const double scale_m2 = round.gate_m * round.gate_m / 9.0;
  const Eigen::Vector2d heading = X_AB.heading();
  for (int i = 0; i < points_B.size(); i += round.stride) {
    const Eigen::Vector2d turned_m = turned(heading, points_B, i);
    const Eigen::Vector2d p_AP = X_AB.p_m + turned_m;
    const bool looks_anew = round.looks_anew || nearest_[i] == kNone;
    const int middle = looks_anew ? place_of(p_AP) : nearest_[i];
    nearest_[i] = nearest(p_AP, {round.gate_m, middle, looks_anew ? kWideWindow : kNarrowWindow});
    const int place = nearest_[i];
    if (place == kNone || (nx_[place] == 0.0 && ny_[place] == 0.0)) continue;
    const double off_m = distance_m(p_AP, place);
    const double spread = scale_m2 / (scale_m2 + off_m * off_m);
    equations.add({nx_[place], ny_[place], turned_m.x() * ny_[place] - turned_m.y() * nx_[place]}, off_m,
                  spread * spread);
  }
  return equations.solve(X_AB, expected_X_AB);
}

Pose2 ScanMatcher::refine(const Points& points_B, const Pose2& expected_X_AB) {
  constexpr std::array kRounds = {Round{0.5, 3, true}, Round{0.35, 3, true}, Round{0.22, 2, true},
                                  Round{0.14, 2, true}};
  nearest_.assign(points_B.size(), kNone);
  Pose2 X_AB = expected_X_AB;
  for (const Round& round : kRounds) X_AB = step(points_B, X_AB, expected_X_AB, round);
  for (int i = 0; i < kMaxLastRounds; ++i) {
    const Pose2 before = X_AB;
    X_AB = step(points_B, X_AB, expected_X_AB, {.gate_m = 0.09});
    const double moved_m = (X_AB.p_m - before.p_m).norm();
    if (moved_m < kConverged && std::abs(wrap_to_pi(X_AB.theta_rad - before.theta_rad)) < kConverged) break;
  }
  return X_AB;
}

ScanMatch ScanMatcher::judge(const Points& points_B, const Pose2& X_AB, int stride) const {
  ScanMatch match{.X_AB = X_AB};
  int num_judged = 0;
  int num_explained = 0;
  const Eigen::Vector2d heading = X_AB.heading();
  for (int i = 0; i < points_B.size(); i += stride) {
    const Eigen::Vector2d p_AP = X_AB.p_m + turned(heading, points_B, i);
    const int beam = beam_of(p_AP);
    if (beam >= geometry_.num_beams || place_of_beam_[beam] == kNone) continue;
    const int place = nearest(p_AP, {3.0 * kExplained_m, place_of_beam_[beam], kNarrowWindow});
    const bool is_explained = place != kNone && std::abs(distance_m(p_AP, place)) <= kExplained_m;
    // What lies behind A's surface A cannot have seen.
    if (!is_explained && p_AP.squaredNorm() > reference_[place_of_beam_[beam]].squaredNorm()) continue;
    ++num_judged;
    if (is_explained) ++num_explained;
  }
  match.explained_ratio = num_judged == 0 ? 0.0 : static_cast<double>(num_explained) / num_judged;
  match.is_trusted = num_judged * stride >= kMinJudged && match.explained_ratio >= kMinExplainedRatio;
  return match;
}

ScanMatch ScanMatcher::match(const Points& points_B, const Pose2& expected_X_AB) {
  if (reference_.size() == 0 || points_B.size() == 0) return {.X_AB = expected_X_AB};
  ScanMatch best = judge(points_B, refine(points_B, expected_X_AB), 2);
  if (best.explained_ratio >= kGoodRatio) return best;
  ScanMatch start;
  for (int k = -kTurns; k <= kTurns; ++k) {
    const Pose2 turned{expected_X_AB.p_m, wrap_to_pi(expected_X_AB.theta_rad + k * kTurnStep_rad)};
    const ScanMatch tried = judge(points_B, turned, 4);
    if (tried.explained_ratio > start.explained_ratio) start = tried;
  }
  const ScanMatch second = judge(points_B, refine(points_B, start.X_AB), 2);
  if (second.explained_ratio > best.explained_ratio) best = second;
  if (!best.is_trusted) best.X_AB = expected_X_AB;
  return best;
}

}  // namespace scanbed
