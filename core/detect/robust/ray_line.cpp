// SPDX-License-Identifier: MIT
#include "core/detect/robust/ray_line.hpp"

#include <algorithm>
#include <limits>

namespace scanbed {
namespace {

/// Cuts of two lanes.
struct LaneCuts {
  Doubles place;
  Doubles chi2;
  Doubles chi2_before;

  /// What is better in `other`, lane by lane.
  void take(const LaneCuts& other) {
    const auto is_better = other.chi2 < chi2;
    place = is_better ? other.place : place;
    chi2 = is_better ? other.chi2 : chi2;
    chi2_before = is_better ? other.chi2_before : chi2_before;
  }
};

}  // namespace

void RayLineSums::build(const Echoes& echoes) {
  const int num_echoes = echoes.size();
  for (std::vector<double>* sums : {&q_, &qx_, &qy_, &qxx_, &qxy_, &qyy_}) {
    sums->resize(num_echoes + 1);
    sums->front() = 0.0;
  }
  // In pairs, as two sums grow as fast as one.
  Doubles q_and_qx{};
  Doubles qy_and_qxx{};
  Doubles qxy_and_qyy{};
  for (int k = 0; k < num_echoes; ++k) {
    const double x = echoes.x_m[k];
    const double y = echoes.y_m[k];
    const double q = echoes.weight_per_m2[k] * (echoes.range_m[k] * echoes.range_m[k]);
    const double qx = q * x;
    const double qy = q * y;
    q_and_qx += Doubles{q, qx};
    qy_and_qxx += Doubles{qy, qx * x};
    qxy_and_qyy += both_lanes(qy) * Doubles{x, y};
    q_[k + 1] = q_and_qx[0];
    qx_[k + 1] = q_and_qx[1];
    qy_[k + 1] = qy_and_qxx[0];
    qxx_[k + 1] = qy_and_qxx[1];
    qxy_[k + 1] = qxy_and_qyy[0];
    qyy_[k + 1] = qxy_and_qyy[1];
  }
}

RayLineSums::Sums<Doubles> RayLineSums::before_two(int place) const {
  return {lanes_at(&q_[place]),   lanes_at(&qx_[place]),  lanes_at(&qy_[place]),
          lanes_at(&qxx_[place]), lanes_at(&qxy_[place]), lanes_at(&qyy_[place])};
}

RayLineSums::Cut RayLineSums::best_cut(Stretch places, int first_cut) const {
  const auto twice = [](const Sums<double>& s) {
    return Sums<Doubles>{both_lanes(s.q),   both_lanes(s.qx),  both_lanes(s.qy),
                         both_lanes(s.qxx), both_lanes(s.qxy), both_lanes(s.qyy)};
  };
  const Sums<Doubles> first = twice(before(places.first));
  const Sums<Doubles> end = twice(before(places.last + 1));
  const Doubles only_first = both_lanes(places.first);
  const Doubles all_but_last = both_lanes(places.last - 1);
  LaneCuts best{both_lanes(places.first), both_lanes(std::numeric_limits<double>::infinity()), Doubles{}};
  for (int i = 0; i < kNumCuts; i += 2) {
    const int cut = std::min(first_cut + i, places.last - 2);
    const Sums<Doubles> middle = before_two(cut + 1);
    const Doubles place = Doubles{0.0, 1.0} + both_lanes(cut);
    // A line explains a single echo wholly; the quotient says nothing there.
    const Doubles before = place > only_first ? chi2(difference(middle, first)) : Doubles{};
    const Doubles after = place < all_but_last ? chi2(difference(end, middle)) : Doubles{};
    best.take({place, before + after, before});
  }
  best.take({swapped(best.place), swapped(best.chi2), swapped(best.chi2_before)});
  return {static_cast<int>(best.place[0]), best.chi2_before[0], best.chi2[0] - best.chi2_before[0]};
}

RayLine RayLineSums::solve(const Sums<double>& s) {
  const double determinant = s.qxx * s.qyy - s.qxy * s.qxy;
  if (determinant <= 0.0) return {};
  RayLine line;
  line.inverse_m = Eigen::Vector2d(s.qyy * s.qx - s.qxy * s.qy, s.qxx * s.qy - s.qxy * s.qx) / determinant;
  line.chi2 = std::max(0.0, s.q - line.inverse_m.x() * s.qx - line.inverse_m.y() * s.qy);
  // The covariance of (a, b) is the inverse of the matrix of the sums; the direction feels what lies across.
  const auto [a, b] = std::pair(line.inverse_m.x(), line.inverse_m.y());
  const double norm2 = a * a + b * b;
  const double across = s.qxx * a * a + 2.0 * s.qxy * a * b + s.qyy * b * b;
  line.direction_rad2 = across / (determinant * norm2 * norm2);
  return line;
}

RayLine RayLineSums::fit(Stretch places) const {
  return solve(between(places));
}

RayLine RayLineSums::fit_both(Stretch a, Stretch b) const {
  Sums<double> sums = between(a);
  const Sums<double> other = between(b);
  sums.q += other.q;
  sums.qx += other.qx;
  sums.qy += other.qy;
  sums.qxx += other.qxx;
  sums.qxy += other.qxy;
  sums.qyy += other.qyy;
  return solve(sums);
}

}  // namespace scanbed
