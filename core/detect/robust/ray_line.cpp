// SPDX-License-Identifier: MIT
#include "core/detect/robust/ray_line.hpp"

#include <algorithm>
#include <limits>

namespace scanbed {
namespace {

/// Cuts, one in each lane.
template <typename Lanes>
struct LaneCuts {
  Lanes place{}, chi2{}, chi2_before{};
};

/// Keeps what is better in `other`, lane by lane.
template <typename Lanes>
[[gnu::always_inline]] inline void take(LaneCuts<Lanes>& best, const LaneCuts<Lanes>& other) {
  const auto is_better = other.chi2 < best.chi2;
  best.place = is_better ? other.place : best.place;
  best.chi2 = is_better ? other.chi2 : best.chi2;
  best.chi2_before = is_better ? other.chi2_before : best.chi2_before;
}

// Pairs of neighbouring values, from the given places on.
[[gnu::always_inline]] inline void load_pairs(const double* values, const int* first_places, Doubles& lanes) {
  load(values + first_places[0], lanes);
}

[[gnu::always_inline]] inline void load_pairs(const double* values, const int* first_places, Quads& lanes) {
  const Doubles low = lanes_at(values + first_places[0]);
  const Doubles high = lanes_at(values + first_places[1]);
  lanes = __builtin_shufflevector(low, high, 0, 1, 2, 3);
}

// In which pair each lane is, by its first lane, and where in it.
[[gnu::always_inline]] inline void number_pairs(Doubles& pair, Doubles& in_pair) {
  pair = Doubles{0.0, 0.0};
  in_pair = Doubles{0.0, 1.0};
}

[[gnu::always_inline]] inline void number_pairs(Quads& pair, Quads& in_pair) {
  pair = Quads{0.0, 0.0, 2.0, 2.0};
  in_pair = Quads{0.0, 1.0, 0.0, 1.0};
}

// Among cuts that are as good as each other the lowest of the first lanes of pairs, then of the second.
[[gnu::always_inline]] inline void fold(const LaneCuts<Doubles>& cuts, LaneCuts<Doubles>& best) {
  best = cuts;
  take(best, {swapped(cuts.place), swapped(cuts.chi2), swapped(cuts.chi2_before)});
}

[[gnu::always_inline]] inline void fold(const LaneCuts<Quads>& cuts, LaneCuts<Doubles>& best) {
  const auto low = [](const Quads& lanes) { return __builtin_shufflevector(lanes, lanes, 0, 1); };
  const auto high = [](const Quads& lanes) { return __builtin_shufflevector(lanes, lanes, 2, 3); };
  const Doubles place = low(cuts.place), other_place = high(cuts.place);
  const Doubles chi2 = low(cuts.chi2), other_chi2 = high(cuts.chi2);
  const auto is_better = (other_chi2 < chi2) | ((other_chi2 == chi2) & (other_place < place));
  fold({is_better ? other_place : place, is_better ? other_chi2 : chi2,
        is_better ? high(cuts.chi2_before) : low(cuts.chi2_before)},
       best);
}

}  // namespace

// With the unit normal n and t across it, (a, b) = n / d: a step along t turns the line by d times as much,
// one along n moves it by -d^2 times as much.
Eigen::Matrix2d RayLine::covariance() const {
  const auto [aa, ab, bb] = information_m2;
  Eigen::Matrix2d of_inverse;
  of_inverse << bb, -ab, -ab, aa;
  of_inverse /= aa * bb - ab * ab;
  const double distance_m = 1.0 / inverse_m.norm();
  const Eigen::Vector2d normal = inverse_m * distance_m;
  Eigen::Matrix2d jacobian;
  jacobian << -normal.y(), normal.x(), -distance_m * normal.x(), -distance_m * normal.y();
  jacobian *= distance_m;
  return jacobian * of_inverse * jacobian.transpose();
}

void RayLineSums::build(const Echoes& echoes) {
  const int num_echoes = echoes.size();
  for (std::vector<double>* sums : {&q_, &qx_, &qy_, &qxx_, &qxy_, &qyy_}) {
    if (sums->size() <= echoes.beam.size()) sums->resize(num_echoes + 1);
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

template <typename Lanes>
[[gnu::always_inline]] inline RayLineSums::Sums<Lanes> RayLineSums::before_pairs(
    const int* first_places) const {
  Sums<Lanes> sums;
  load_pairs(q_.data(), first_places, sums.q);
  load_pairs(qx_.data(), first_places, sums.qx);
  load_pairs(qy_.data(), first_places, sums.qy);
  load_pairs(qxx_.data(), first_places, sums.qxx);
  load_pairs(qxy_.data(), first_places, sums.qxy);
  load_pairs(qyy_.data(), first_places, sums.qyy);
  return sums;
}

template <typename Lanes>
[[gnu::always_inline]] inline RayLineSums::Sums<Lanes> RayLineSums::before_in_all_lanes(int place) const {
  // Less nothing is the same in all lanes.
  return {q_[place] - Lanes{},   qx_[place] - Lanes{},  qy_[place] - Lanes{},
          qxx_[place] - Lanes{}, qxy_[place] - Lanes{}, qyy_[place] - Lanes{}};
}

template <typename Lanes>
[[gnu::always_inline]] inline void RayLineSums::find_best_cut(Stretch places, int first_cut,
                                                              Cut& best) const {
  constexpr int kNumPairs = sizeof(Lanes) / (2 * sizeof(double));
  const Sums<Lanes> first = before_in_all_lanes<Lanes>(places.first);
  const Sums<Lanes> end = before_in_all_lanes<Lanes>(places.last + 1);
  const double first_place = places.first;
  const double last_place = places.last;
  Lanes pair, in_pair, chi2_before, chi2_after;
  number_pairs(pair, in_pair);
  pair += static_cast<double>(first_cut);
  LaneCuts<Lanes> cuts;
  cuts.place += first_place;
  cuts.chi2 += std::numeric_limits<double>::infinity();
  for (int i = 0; i < kNumCuts; i += 2 * kNumPairs) {
    int behind[kNumPairs];
    for (int k = 0; k < kNumPairs; ++k) behind[k] = std::min(first_cut + i + 2 * k, places.last - 2) + 1;
    const Sums<Lanes> middle = before_pairs<Lanes>(behind);
    const Lanes place = (pair < last_place - 2.0 ? pair : last_place - 2.0 - Lanes{}) + in_pair;
    pair += 2.0 * kNumPairs;
    find_chi2(difference(middle, first), chi2_before);
    find_chi2(difference(end, middle), chi2_after);
    // A line explains a single echo wholly; the quotient says nothing there.
    chi2_before = place > first_place ? chi2_before : Lanes{};
    chi2_after = place < last_place - 1.0 ? chi2_after : Lanes{};
    take(cuts, {place, chi2_before + chi2_after, chi2_before});
  }
  LaneCuts<Doubles> folded;
  fold(cuts, folded);
  best = {static_cast<int>(folded.place[0]), folded.chi2_before[0], folded.chi2[0] - folded.chi2_before[0]};
}

template <typename Lanes>
[[gnu::always_inline]] inline void RayLineSums::find_best_cuts(std::span<const Stretch> parts,
                                                               const int* first_cuts, Cut* best) const {
  for (std::size_t i = 0; i < parts.size(); ++i) find_best_cut<Lanes>(parts[i], first_cuts[i], best[i]);
}

#if defined(SCANBED_HAS_AVX2)
SCANBED_AVX2 void RayLineSums::find_best_cuts_avx2(std::span<const Stretch> parts, const int* first_cuts,
                                                   Cut* best) const {
  find_best_cuts<Quads>(parts, first_cuts, best);
}
#endif

void RayLineSums::best_cuts(std::span<const Stretch> parts, std::span<const int> first_cuts,
                            std::span<Cut> best) const {
#if defined(SCANBED_HAS_AVX2)
  if (instructions_ == InstructionSet::kAvx2) {
    return find_best_cuts_avx2(parts, first_cuts.data(), best.data());
  }
#endif
  find_best_cuts<Doubles>(parts, first_cuts.data(), best.data());
}

RayLineSums::Cut RayLineSums::best_cut(Stretch places, int first_cut) const {
  Cut best;
  best_cuts({&places, 1}, {&first_cut, 1}, {&best, 1});
  return best;
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
  line.information_m2 = {s.qxx, s.qxy, s.qyy};
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
