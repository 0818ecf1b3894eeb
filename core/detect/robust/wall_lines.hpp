// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/detect/detector_options.hpp"
#include "core/detect/features.hpp"
#include "core/detect/robust/echoes.hpp"
#include "core/detect/robust/line_pieces.hpp"
#include "core/detect/robust/ray_line.hpp"

namespace scanbed {

/// Makes lines of straight pieces.
///
/// A few noisy echoes leave the direction of a short piece open. Where another piece may be more of the same
/// wall, beyond a niche or behind something nearer, it takes its direction from both. Pieces whose direction
/// stays uncertain are dropped.
class WallLines {
 public:
  /// Begins a scan; what it refers to lives as long as lines are made.
  void begin(const Echoes& echoes, const RayLineSums& sums, const DetectorOptions& options);

  /// Appends the lines of all pieces that no arc took, in their order.
  void append(std::span<const LinePiece> pieces, std::vector<Line>& lines);

 private:
  struct Wall {
    Stretch places;
    RayLine line;  ///< through its echoes
  };

  void collect(std::span<const LinePiece> pieces);
  void drop_foreign_ends(Wall& wall) const;
  RayLine line_with_others(std::size_t wall) const;

  const Echoes* echoes_ = nullptr;
  const RayLineSums* sums_ = nullptr;
  const DetectorOptions* options_ = nullptr;
  std::vector<Wall> walls_;
};

}  // namespace scanbed
