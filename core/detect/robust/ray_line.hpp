// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "core/detect/robust/echoes.hpp"
#include "core/detect/robust/surface_runs.hpp"
#include "core/simd/double_lanes.hpp"
#include "core/simd/instruction_set.hpp"

namespace scanbed {

/// A straight wall as rays see it: 1 / range = a cos(bearing) + b sin(bearing), linear in its parameters.
struct RayLine {
  Eigen::Vector2d inverse_m = Eigen::Vector2d::Zero();  ///< (a, b): normal of the wall / its distance
  double chi2 = 0.0;  ///< sum of squared range residuals in units of their sigma
  double direction_rad2 = std::numeric_limits<double>::infinity();  ///< variance of its direction
  /// Inverse covariance of (a, b): aa, ab, bb.
  std::array<double, 3> information_m2 = {};

  /// Of the normal's bearing (rad) and the distance (m).
  /// @pre  direction_rad2 is finite.
  Eigen::Matrix2d covariance() const;
};

/// Sums from which the line through any stretch of echoes is fitted in constant time.
///
/// An error dr of range is an error dr / r^2 of its inverse; so a point (x, y) at range r with sigma s adds
/// q (a x + b y - 1)^2 with q = (r / s)^2.
class RayLineSums {
 public:
  explicit RayLineSums(InstructionSet instructions = widest_instruction_set())
      : instructions_(instructions) {}

  void build(const Echoes& echoes);

  /// Weighted least squares over a stretch of at least two echoes.
  RayLine fit(Stretch places) const;

  /// What the line through a stretch leaves unexplained.
  double chi2_of(Stretch places) const;

  /// One line through both.
  RayLine fit_both(Stretch a, Stretch b) const;

  /// A stretch cut in two behind a place: what the lines on both sides leave unexplained.
  struct Cut {
    int place = 0;
    double chi2_before = 0.0;
    double chi2_after = 0.0;

    double chi2() const { return chi2_before + chi2_after; }
  };
  static constexpr int kNumCuts = 8;  ///< that are compared at a time
  /// The best of kNumCuts neighbouring cuts from the first on; of fewer where the stretch ends.
  /// @pre  places.size() >= 3, places.first <= first_cut < places.last.
  Cut best_cut(Stretch places, int first_cut) const;
  /// The same of many stretches.
  void best_cuts(std::span<const Stretch> parts, std::span<const int> first_cuts, std::span<Cut> best) const;

 private:
  template <typename T>
  struct Sums {
    T q, qx, qy, qxx, qxy, qyy;
  };
  template <typename T>
  static Sums<T> difference(const Sums<T>& a, const Sums<T>& b);
  template <typename T>
  static void find_chi2(const Sums<T>& sums, T& chi2);
  Sums<double> before(int place) const;
  Sums<double> between(Stretch places) const;
  template <typename Lanes>
  Sums<Lanes> before_pairs(const int* first_places) const;
  template <typename Lanes>
  Sums<Lanes> before_in_all_lanes(int place) const;
  template <typename Lanes>
  void find_best_cut(Stretch places, int first_cut, Cut& best) const;
  template <typename Lanes>
  void find_best_cuts(std::span<const Stretch> parts, const int* first_cuts, Cut* best) const;
  SCANBED_AVX2 void find_best_cuts_avx2(std::span<const Stretch> parts, const int* first_cuts,
                                        Cut* best) const;
  static RayLine solve(const Sums<double>& sums);

  InstructionSet instructions_;
  std::vector<double> q_, qx_, qy_, qxx_, qxy_, qyy_;  ///< over the echoes before each, and over all
};

// Here for the inner loops that cut surfaces into lines.

template <typename T>
[[gnu::always_inline]] inline RayLineSums::Sums<T> RayLineSums::difference(const Sums<T>& a,
                                                                           const Sums<T>& b) {
  return {a.q - b.q, a.qx - b.qx, a.qy - b.qy, a.qxx - b.qxx, a.qxy - b.qxy, a.qyy - b.qyy};
}

inline RayLineSums::Sums<double> RayLineSums::before(int place) const {
  return {q_[place], qx_[place], qy_[place], qxx_[place], qxy_[place], qyy_[place]};
}

inline RayLineSums::Sums<double> RayLineSums::between(Stretch places) const {
  return difference(before(places.last + 1), before(places.first));
}

template <typename T>
[[gnu::always_inline]] inline void RayLineSums::find_chi2(const Sums<T>& s, T& chi2) {
  const T determinant = s.qxx * s.qyy - s.qxy * s.qxy;
  const T explained = (s.qyy * s.qx - s.qxy * s.qy) * s.qx + (s.qxx * s.qy - s.qxy * s.qx) * s.qy;
  const T left = s.q - explained / determinant;
  // Never less but for rounding, or where all echoes lie on one ray.
  chi2 = left > 0.0 ? left : T{};
}

inline double RayLineSums::chi2_of(Stretch places) const {
  if (places.size() < 2) return 0.0;
  double chi2;
  find_chi2(between(places), chi2);
  return chi2;
}

}  // namespace scanbed
