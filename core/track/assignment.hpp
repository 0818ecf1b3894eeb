// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace scanbed {

inline constexpr int kUnassigned = -1;

/// One-to-one assignment of rows to columns at the least total cost, where leaving a row alone has a price.
/// Keeps its storage, so that it allocates nothing once it has seen its largest problem.
///
/// @par Source  H. W. Kuhn, "The Hungarian method for the assignment problem", 1955, as shortest augmenting
///              paths with potentials; each row has a column of its own in addition, which means "alone".
class Assignment {
 public:
  /// Begins a problem in which every pair is forbidden and a row alone costs `alone_cost`.
  void reset(int num_rows, int num_columns, double alone_cost);

  /// Allows a pair. Pairs at `alone_cost` and above are never made. @pre cost is finite.
  void allow(int row, int column, double cost);

  /// The column of each row, or kUnassigned. Valid until the next reset().
  std::span<const int> solve();

 private:
  static constexpr int kNone = -1;

  double cost(int row, int column) const;
  void assign_row(int row);
  int nearest_open_column() const;
  void scan_row(int row, int through_column);

  int num_rows_ = 0;
  int num_columns_ = 0;  ///< real ones; column num_columns_ + i is "row i alone"
  double alone_cost_ = 0.0;
  double offset_ = 0.0;  ///< distance at which the current row is scanned
  std::vector<double> cost_;
  std::vector<double> row_price_, column_price_;
  std::vector<double> distance_;
  std::vector<int> came_from_row_;
  std::vector<char> is_closed_;
  std::vector<int> row_of_column_, column_of_row_;
};

}  // namespace scanbed
