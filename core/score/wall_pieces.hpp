// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "core/detect/features.hpp"
#include "core/scan/laser_scan.hpp"
#include "core/scan/truth.hpp"

namespace scanbed {

/// A stretch of a wall that a scan shows: neighbouring beams on one wall, where up to three beams in between
/// met something else (a thin post in front does not make two walls).
struct WallPiece {
  int object = kNoObject;  ///< index into Truth::objects
  BeamSpan beams;
  int num_beams = 0;                                 ///< that met this wall and gave an echo
  Eigen::Vector2d from_m = Eigen::Vector2d::Zero();  ///< true point of the first beam, p_SA
  Eigen::Vector2d to_m = Eigen::Vector2d::Zero();    ///< true point of the last beam, p_SB

  double length_m() const { return (to_m - from_m).norm(); }

  /// At least 6 beams and 0.3 m: must be found.
  bool is_resolvable() const;
};

/// Where beam i truly ended, sensor frame. @pre truth.beams[i].object is no kNoObject.
Eigen::Vector2d true_point_m(const Truth& truth, const LaserScan& scan, int beam);

/// The pieces of all walls in view, in rising order of their first beam.
std::vector<WallPiece> visible_wall_pieces(const Truth& truth, const LaserScan& scan);

/// The same, found again and again: keeps its storage from scan to scan.
class WallPieceFinder {
 public:
  const std::vector<WallPiece>& find(const Truth& truth, const LaserScan& scan);

  std::vector<WallPiece> take() { return std::move(pieces_); }  ///< what find() found

 private:
  std::vector<WallPiece> pieces_;
  std::vector<int> open_piece_;  ///< of each object: index into pieces_
};

}  // namespace scanbed
