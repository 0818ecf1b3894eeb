// SPDX-License-Identifier: MIT
#include "sim/map/trace_outlines.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "core/errors/input_error.hpp"
#include "sim/world/solid_geometry.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr std::size_t kMany = 10'000;

// Rows as drawn: the first one is the highest.
OccupiedCells cells(const std::vector<std::string>& rows) {
  OccupiedCells grid{static_cast<int>(rows.front().size()), static_cast<int>(rows.size()), {}};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) grid.cells.push_back(c == '#');
  }
  return grid;
}

OccupiedCells cells_where(int num_columns, int num_rows, const std::function<bool(const Vector2d&)>& inside) {
  OccupiedCells grid{num_columns, num_rows, {}};
  for (int row = 0; row < num_rows; ++row) {
    for (int column = 0; column < num_columns; ++column) {
      grid.cells.push_back(inside({column + 0.5, row + 0.5}));
    }
  }
  return grid;
}

double area(const Outline& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d& a = outline[i];
    const Vector2d& b = outline[(i + 1) % outline.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

double distance_to_outlines(const std::vector<Outline>& outlines, const Vector2d& point) {
  double nearest = 1e9;
  for (const Outline& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      nearest = std::min(nearest, distance_m({outline[i], outline[(i + 1) % outline.size()]}, point));
    }
  }
  return nearest;
}

void expect_corners(Outline outline, const Outline& expected) {
  const auto first = std::find(outline.begin(), outline.end(), expected.front());
  ASSERT_NE(first, outline.end());
  std::rotate(outline.begin(), first, outline.end());
  ASSERT_EQ(outline.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(outline[i], expected[i]) << i;
}

TEST(TraceOutlinesTest, NothingOccupiedHasNoOutline) {
  EXPECT_TRUE(trace_outlines(cells({"...", "..."}), kMany).empty());
  EXPECT_TRUE(trace_outlines({}, kMany).empty());
}

TEST(TraceOutlinesTest, RectanglesAreExact) {
  const std::vector<Outline> one = trace_outlines(cells({"....", ".#..", "...."}), kMany);
  ASSERT_EQ(one.size(), 1u);
  expect_corners(one[0], {{1, 1}, {2, 1}, {2, 2}, {1, 2}});
  // A wall one cell thick, and a picture that is full.
  const std::vector<Outline> wall = trace_outlines(cells({"......", ".####.", "......"}), kMany);
  ASSERT_EQ(wall.size(), 1u);
  expect_corners(wall[0], {{1, 1}, {5, 1}, {5, 2}, {1, 2}});
  const std::vector<Outline> full = trace_outlines(cells({"###", "###"}), kMany);
  ASSERT_EQ(full.size(), 1u);
  expect_corners(full[0], {{0, 0}, {3, 0}, {3, 2}, {0, 2}});
}

TEST(TraceOutlinesTest, AHallIsItsOutsideAndClockwiseItsInside) {
  const std::vector<Outline> hall =
      trace_outlines(cells({"#######", "#.....#", "#.....#", "#..##.#", "#######"}), kMany);
  ASSERT_EQ(hall.size(), 2u);
  EXPECT_DOUBLE_EQ(area(hall[0]), 35.0);
  // The bump's upper side is two cells long and one above the floor: it is kept, its sides become slants.
  EXPECT_NEAR(area(hall[1]), -13.0, 1.0);
}

TEST(TraceOutlinesTest, CellsThatTouchAtACornerBelongTogether) {
  EXPECT_EQ(trace_outlines(cells({"##..", "##..", "..##", "..##"}), kMany).size(), 1u);
}

// A slanting wall of any slope, drawn where cells have their middles below it, is one straight wall again.
TEST(TraceOutlinesTest, SlantingWallsComeOutStraight) {
  for (const double slope : {0.05, 0.2, 0.37, 0.5, 0.77, 1.0}) {
    const auto inside = [&](const Vector2d& p) { return p.y() < 5.3 + slope * p.x() && p.y() > 2.0; };
    const std::vector<Outline> outlines = trace_outlines(cells_where(100, 130, inside), kMany);
    ASSERT_EQ(outlines.size(), 1u) << slope;
    EXPECT_LE(outlines[0].size(), 12u) << slope;
    for (double x = 3.0; x < 97.0; x += 0.5) {
      EXPECT_LT(distance_to_outlines(outlines, {x, 5.3 + slope * x}), 1.0) << slope << " at " << x;
    }
  }
}

TEST(TraceOutlinesTest, ACircleKeepsItsRadius) {
  const Vector2d center(30.2, 29.7);
  for (const double radius : {3.0, 8.0, 25.0}) {
    const std::vector<Outline> outlines = trace_outlines(
        cells_where(60, 60, [&](const Vector2d& p) { return (p - center).norm() < radius; }), kMany);
    ASSERT_EQ(outlines.size(), 1u);
    for (const Vector2d& corner : outlines[0]) EXPECT_NEAR((corner - center).norm(), radius, 1.0);
    EXPECT_NEAR(area(outlines[0]), kPi * radius * radius, 2.0 * kPi * radius * 0.5);
  }
}

TEST(TraceOutlinesTest, RefusesMoreWallsThanAllowed) {
  const OccupiedCells dots = cells_where(100, 100, [](const Vector2d& p) {
    return static_cast<int>(p.x()) % 2 == 0 && static_cast<int>(p.y()) % 2 == 0;
  });
  EXPECT_EQ(trace_outlines(dots, 10'000).size(), 2500u);
  EXPECT_THROW(trace_outlines(dots, 9'999), InputError);
}

// The cells' own outlines, side by side.
std::vector<Edge> sides_of(const OccupiedCells& grid) {
  std::vector<Edge> sides;
  for (int y = 0; y <= grid.num_rows; ++y) {
    for (int x = 0; x <= grid.num_columns; ++x) {
      const Vector2d p(x, y);
      if (grid.at(x, y) != grid.at(x, y - 1)) sides.push_back({p, p + Vector2d(1, 0)});
      if (grid.at(x, y) != grid.at(x - 1, y)) sides.push_back({p, p + Vector2d(0, 1)});
    }
  }
  return sides;
}

RC_GTEST_PROP(TraceOutlinesTest, OutlinesAreNowhereFartherThanACellFromTheCells, ()) {
  const int num_columns = *rc::gen::inRange(1, 12);
  const int num_rows = *rc::gen::inRange(1, 12);
  OccupiedCells grid{num_columns, num_rows, {}};
  const int share = *rc::gen::inRange(1, 10);
  for (const int die : *rc::gen::container<std::vector<int>>(static_cast<std::size_t>(num_columns * num_rows),
                                                             rc::gen::inRange(0, 10))) {
    grid.cells.push_back(die < share);
  }
  const std::vector<Edge> sides = sides_of(grid);
  const std::vector<Outline> outlines = trace_outlines(grid, kMany);
  RC_ASSERT(outlines.empty() == sides.empty());
  constexpr double kSlack = 1e-9;
  for (const Outline& outline : outlines) {
    RC_ASSERT(outline.size() >= 3u);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vector2d way = outline[(i + 1) % outline.size()] - outline[i];
      RC_ASSERT(way.norm() > 0.1);
      for (double t = 0.0; t <= 1.0; t += 0.125) {
        const Vector2d point = outline[i] + t * way;
        const bool is_near = std::any_of(sides.begin(), sides.end(), [&](const Edge& side) {
          return distance_m(side, point) <= 1.0 + kSlack;
        });
        RC_ASSERT(is_near);
      }
    }
  }
  for (const Edge& side : sides) {
    RC_ASSERT(distance_to_outlines(outlines, 0.5 * (side.a_m + side.b_m)) <= 1.0 + kSlack);
  }
}

}  // namespace
}  // namespace scanbed::sim
