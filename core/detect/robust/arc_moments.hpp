// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/robust/echoes.hpp"
#include "core/detect/robust/surface_runs.hpp"

namespace scanbed {

/// Sums from which the chi squared of a circle through stretches of surfaces follows in constant time: quick
/// to say what is no arc. Surfaces are summed when they are first asked for.
class ArcMoments {
 public:
  /// Begins a scan; the arguments live as long as chi2 is asked.
  void begin(const Echoes& echoes, const std::vector<int>& order);

  /// Chi squared of range of the circle that fits the stretch best in algebraic distance.
  ///
  /// Off the least in geometric distance by a factor of a few at most; infinite where the points lie on a
  /// line or on a hollow as the sensor sees it.
  /// @pre  places lie within the surface.
  double chi2(Stretch surface, Stretch places);

  /// The same of one circle through two whole surfaces.
  double chi2_of_both(Stretch a, Stretch b);

 private:
  struct Sums {
    double w = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, xz = 0, yz = 0, zz = 0;  // z = x^2 + y^2
  };
  static double chi2_of(const Sums& sums);
  void sum_up(Stretch surface);

  const Echoes* echoes_ = nullptr;
  const std::vector<int>* order_ = nullptr;
  std::vector<Sums> sums_;       ///< at each place: from the first of its surface to it
  std::vector<char> is_summed_;  ///< at the first place of each surface
};

}  // namespace scanbed
