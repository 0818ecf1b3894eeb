// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace scanbed::sim {

/// Which cells of a grid are occupied; row 0 is at y = 0, its lowest.
struct OccupiedCells {
  int num_columns = 0;
  int num_rows = 0;
  std::vector<bool> cells;  ///< row by row

  /// False outside the grid.
  bool at(int column, int row) const {
    if (column < 0 || row < 0 || column >= num_columns || row >= num_rows) return false;
    return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(num_columns) +
                 static_cast<std::size_t>(column)];
  }
};

/// A closed polygon, in cells: the grid's lowest left corner is (0, 0), its first cell ends at (1, 1).
using Outline = std::vector<Eigen::Vector2d>;

/// Outlines of all that is occupied and of the holes in it; cells that touch at a corner belong together.
/// What is occupied lies to the left of an outline.
///
/// Steps of one cell are what slanting walls look like in a grid: they become straight lines through the
/// middles of the steps, and what then lies within half a cell of a straight line is one wall. Corners
/// between longer edges stay where they are; outlines of rectangles are exact. No point of an outline is
/// farther than one cell from the cells' own.
///
/// @param max_points  of all outlines.
/// @throws InputError where there are more, once that is known.
/// @par Cost  O(cells); memory for one bit a cell and for the longest outline.
std::vector<Outline> trace_outlines(const OccupiedCells& grid, std::size_t max_points);

}  // namespace scanbed::sim
