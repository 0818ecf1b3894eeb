// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/features.hpp"
#include "core/interpret/interpret_options.hpp"
#include "core/interpret/piece_order.hpp"
#include "core/interpret/scene.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// Groups straight pieces into walls across what hides them and across doors, and finds the doors. The pieces
/// themselves stay as they were measured.
class WallGroups {
 public:
  /// Appends walls and doors. @param lines  rise in beams.first.
  void find(const LaserScan& scan, const std::vector<Line>& lines, const InterpretOptions& options,
            Scene& scene);

 private:
  /// The piece that goes on where this one ends, or -1.
  int next_of(int piece, const std::vector<Line>& lines, const PieceOrder& order,
              const InterpretOptions& options) const;
  void link(const LaserScan& scan, const std::vector<Line>& lines, const InterpretOptions& options,
            Scene& scene);
  void add_wall(const std::vector<Line>& lines, int first, const InterpretOptions& options, Scene& scene);

  std::vector<int> next_;       ///< of each piece: the next one of its wall, or -1
  std::vector<int> longest_;    ///< of each piece: the longest one of its wall up to it
  std::vector<char> is_later_;  ///< of each piece: another one of its wall comes before it
};

}  // namespace scanbed
