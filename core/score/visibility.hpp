// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/scan/laser_scan.hpp"
#include "core/scan/truth.hpp"
#include "core/score/wall_pieces.hpp"

namespace scanbed {

/// Beams that a cylinder would get if nothing stood before it and the field of view had no edge.
///
/// @param p_SC  its centre; @param radius_m  > 0. A sensor inside gets every beam of a full turn.
int num_unobstructed_beams(const Eigen::Vector2d& p_SC, double radius_m, const ScanGeometry& geometry);

/// An object that fewer beams met is hidden.
inline constexpr int kMinVisibleBeams = 3;

/// Sets num_clean_beams and visibility of every object from the beams' labels. Beams without an echo show
/// nothing.
///
/// Hidden: fewer than kMinVisibleBeams. Resolvable: a circle with at least 6 clean beams or a leg with at
/// least 4, each with at least 90 % of its unobstructed beams; a wall with a piece of at least 6 beams and
/// 0.3 m. Else marginal.
///
/// @pre  truth.beams has as many entries as scan has beams.
void classify_visibility(Truth& truth, const LaserScan& scan);

/// The same, scan after scan: keeps its storage, so that the steady state allocates nothing.
class VisibilityClassifier {
 public:
  void classify(Truth& truth, const LaserScan& scan);

 private:
  void count_beams(Truth& truth, const LaserScan& scan);

  std::vector<int> num_beams_;  ///< on each object, mixed ones too
  WallPieceFinder wall_pieces_;
};

}  // namespace scanbed
