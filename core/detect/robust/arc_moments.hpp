// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/detect/robust/arc_fit.hpp"
#include "core/detect/robust/echoes.hpp"
#include "core/detect/robust/surface_runs.hpp"

namespace scanbed {

/// The circle that fits echoes best in algebraic distance (Kasa).
struct AlgebraicArc {
  Cylinder cylinder;
  /// Of the ranges. Off the least in geometric distance by a factor of a few at most.
  double chi2 = 0.0;
};

/// Sums from which the algebraic circle through stretches of echoes follows in constant time: quick to say
/// what is no arc, and where to begin to fit one. Echoes are summed when they are first asked for.
class ArcMoments {
 public:
  /// Begins a scan; the echoes live as long as arcs are asked for.
  void begin(const Echoes& echoes);

  /// Empty where the echoes lie on a line or on a hollow as the sensor sees it. Quick where stretches are
  /// asked for in rising order of their first echo, the longest first.
  std::optional<AlgebraicArc> arc(Stretch places);

  /// The same of one circle through two stretches.
  std::optional<AlgebraicArc> arc_of_both(Stretch a, Stretch b) const;

 private:
  struct Sums {
    // z = x^2 + y^2; x and y as a pair, as they are written and read.
    double x = 0, y = 0, w = 0, xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, zz = 0;
  };
  static std::optional<AlgebraicArc> solve(const Sums& sums);
  static Sums difference(const Sums& a, const Sums& b);
  Sums plus(Sums sums, int place) const;
  void sum_up(Stretch places);

  const Echoes* echoes_ = nullptr;
  std::vector<Sums> sums_;  ///< at each place that is summed: over the first of them to it
  Stretch summed_{0, -1};
};

}  // namespace scanbed
