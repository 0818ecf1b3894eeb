// SPDX-License-Identifier: MIT
#include "core/track/assignment.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

namespace scanbed {
namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();

using Costs = std::vector<std::vector<double>>;  // [row][column]

// Tries all: this row with every free column, or alone, and the rest behind it.
double least_cost(const Costs& costs, std::size_t row, std::vector<bool>& taken, double alone_cost) {
  if (row == costs.size()) return 0.0;
  double least = alone_cost + least_cost(costs, row + 1, taken, alone_cost);
  for (std::size_t column = 0; column < taken.size(); ++column) {
    if (taken[column] || costs[row][column] == kForbidden) continue;
    taken[column] = true;
    least = std::min(least, costs[row][column] + least_cost(costs, row + 1, taken, alone_cost));
    taken[column] = false;
  }
  return least;
}

double cost_of(const Costs& costs, std::span<const int> columns, double alone_cost) {
  double total = 0.0;
  for (std::size_t row = 0; row < costs.size(); ++row) {
    total += columns[row] == kUnassigned ? alone_cost : costs[row][columns[row]];
  }
  return total;
}

std::span<const int> solve(Assignment& assignment, const Costs& costs, int num_columns, double alone_cost) {
  assignment.reset(static_cast<int>(costs.size()), num_columns, alone_cost);
  for (std::size_t row = 0; row < costs.size(); ++row) {
    for (int column = 0; column < num_columns; ++column) {
      if (costs[row][column] != kForbidden)
        assignment.allow(static_cast<int>(row), column, costs[row][column]);
    }
  }
  return assignment.solve();
}

RC_GTEST_PROP(AssignmentTest, CostsAsLittleAsTheBestOfAllAssignments, ()) {
  Assignment assignment;
  for (int problem = 0; problem < 3; ++problem) {  // the second and third find used buffers
    const int num_rows = *rc::gen::inRange(0, 6);
    const int num_columns = *rc::gen::inRange(0, 6);
    Costs costs(num_rows, std::vector<double>(num_columns, kForbidden));
    for (auto& row : costs) {
      for (double& cost : row) {
        if (*rc::gen::inRange(0, 4) > 0) cost = *rc::gen::inRange(0, 40) / 20.0;
      }
    }
    const std::span<const int> columns = solve(assignment, costs, num_columns, 1.0);
    RC_ASSERT(static_cast<int>(columns.size()) == num_rows);
    std::set<int> seen;
    for (int row = 0; row < num_rows; ++row) {
      if (columns[row] == kUnassigned) continue;
      RC_ASSERT(costs[row][columns[row]] < 1.0);
      RC_ASSERT(seen.insert(columns[row]).second);
    }
    std::vector<bool> taken(num_columns, false);
    RC_ASSERT(std::abs(cost_of(costs, columns, 1.0) - least_cost(costs, 0, taken, 1.0)) < 1e-9);
  }
}

TEST(AssignmentTest, GivesUpTheNearestPairWhereThatCostsMoreInAll) {
  Assignment assignment;
  // Nearest first would take (0, 0) at 0.1 and leave row 1 nothing.
  const std::span<const int> columns = solve(assignment, {{0.1, 0.2}, {0.3, kForbidden}}, 2, 1.0);
  EXPECT_EQ(columns[0], 1);
  EXPECT_EQ(columns[1], 0);
}

TEST(AssignmentTest, LeavesARowAloneRatherThanPairItAtItsPrice) {
  Assignment assignment;
  EXPECT_EQ(solve(assignment, {{1.0}}, 1, 1.0)[0], kUnassigned);
  EXPECT_EQ(solve(assignment, {{0.99}}, 1, 1.0)[0], 0);
}

TEST(AssignmentTest, NothingToAssignIsFine) {
  Assignment assignment;
  EXPECT_TRUE(solve(assignment, {}, 3, 1.0).empty());
  EXPECT_EQ(solve(assignment, {{}}, 0, 1.0)[0], kUnassigned);
}

}  // namespace
}  // namespace scanbed
