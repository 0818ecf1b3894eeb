// SPDX-License-Identifier: MIT
#include "core/track/assignment.hpp"

#include <limits>

namespace scanbed {
namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();

}  // namespace

void Assignment::reset(int num_rows, int num_columns, double alone_cost) {
  num_rows_ = num_rows;
  num_columns_ = num_columns;
  alone_cost_ = alone_cost;
  cost_.assign(static_cast<std::size_t>(num_rows) * static_cast<std::size_t>(num_columns), kForbidden);
}

void Assignment::allow(int row, int column, double cost) {
  if (cost < alone_cost_) cost_[static_cast<std::size_t>(row) * num_columns_ + column] = cost;
}

double Assignment::cost(int row, int column) const {
  if (column < num_columns_) return cost_[static_cast<std::size_t>(row) * num_columns_ + column];
  if (column - num_columns_ == row) return alone_cost_;
  return kForbidden;
}

std::span<const int> Assignment::solve() {
  const int num_all_columns = num_columns_ + num_rows_;
  row_price_.assign(num_rows_, 0.0);
  column_price_.assign(num_all_columns, 0.0);
  row_of_column_.assign(num_all_columns, kNone);
  column_of_row_.assign(num_rows_, kUnassigned);
  for (int row = 0; row < num_rows_; ++row) assign_row(row);
  for (int row = 0; row < num_rows_; ++row) column_of_row_[row] = kUnassigned;
  for (int column = 0; column < num_columns_; ++column) {
    if (row_of_column_[column] != kNone) column_of_row_[row_of_column_[column]] = column;
  }
  return column_of_row_;
}

// Dijkstra over columns by reduced cost, from `row` to the nearest column that nobody has. There always is
// one: the row's own.
void Assignment::assign_row(int row) {
  const int num_all_columns = num_columns_ + num_rows_;
  distance_.assign(num_all_columns, kForbidden);
  came_from_row_.assign(num_all_columns, kNone);
  is_closed_.assign(num_all_columns, 0);
  offset_ = 0.0;
  scan_row(row, kNone);
  int column = nearest_open_column();
  while (row_of_column_[column] != kNone) {
    is_closed_[column] = 1;
    offset_ = distance_[column];
    scan_row(row_of_column_[column], column);
    column = nearest_open_column();
  }
  // Prices change so that all edges of the tree are tight and no reduced cost is negative.
  const double end_distance = distance_[column];
  row_price_[row] += end_distance;
  for (int closed = 0; closed < num_all_columns; ++closed) {
    if (is_closed_[closed] == 0) continue;
    const double slack = end_distance - distance_[closed];
    column_price_[closed] -= slack;
    row_price_[row_of_column_[closed]] += slack;
  }
  // Along the path each row takes the column that was found through it.
  while (column != kNone) {
    const int taker = came_from_row_[column];
    row_of_column_[column] = taker;
    const int given_up = column_of_row_[taker];
    column_of_row_[taker] = column;
    column = given_up;
  }
}

int Assignment::nearest_open_column() const {
  int nearest = kNone;
  for (int column = 0; column < num_columns_ + num_rows_; ++column) {
    if (is_closed_[column] != 0 || distance_[column] == kForbidden) continue;
    if (nearest == kNone || distance_[column] < distance_[nearest]) nearest = column;
  }
  return nearest;
}

void Assignment::scan_row(int row, int through_column) {
  const auto relax = [&](int column) {
    if (column == through_column || is_closed_[column] != 0) return;
    const double distance = offset_ + cost(row, column) - row_price_[row] - column_price_[column];
    if (distance >= distance_[column]) return;
    distance_[column] = distance;
    came_from_row_[column] = row;
  };
  for (int column = 0; column < num_columns_; ++column) relax(column);
  relax(num_columns_ + row);
}

}  // namespace scanbed
