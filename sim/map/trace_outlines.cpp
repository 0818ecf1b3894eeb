// SPDX-License-Identifier: MIT
#include "sim/map/trace_outlines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/errors/input_error.hpp"
#include "core/geometry/angles.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kTolerance = 0.5;  // of a cell, between outline and straight walls

/// Corner of cells, and a way along their sides: 0 east, 1 north, 2 west, 3 south.
struct Walker {
  int x;
  int y;
  int way;

  bool operator==(const Walker&) const = default;
};

constexpr std::array<int, 4> kDx = {1, 0, -1, 0};
constexpr std::array<int, 4> kDy = {0, 1, 0, -1};

/// A straight piece of an outline, whole cells long, that turns at its end.
struct Run {
  Vector2d from;
  int way;
  int length;
};

// The cell ahead of a corner, to the left of the way or to its right.
bool is_occupied_ahead(const OccupiedCells& grid, const Walker& at, bool left) {
  // From the corner (x, y) cells reach to the north-east; looking another way, others are ahead.
  static constexpr std::array<std::array<int, 2>, 4> kNorthEastThenRound = {
      {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
  const std::array<int, 2>& cell = kNorthEastThenRound[(at.way + (left ? 0 : 3)) % 4];
  return grid.at(at.x + cell[0], at.y + cell[1]);
}

/// Walks round everything once.
class Tracer {
 public:
  explicit Tracer(const OccupiedCells& grid) : grid_(grid), walked_(grid.cells.size(), false) {}

  bool is_new_lower_side(int column, int row) const {
    return grid_.at(column, row) && !grid_.at(column, row - 1) && !walked_[index(column, row)];
  }

  /// Along the outline that holds the lower side of this cell, from its left end. The first side that is new
  /// in its row begins at a corner: what lies to the left on the same line was walked with it.
  void walk(int column, int row, std::vector<Run>& runs) {
    runs.clear();
    const Walker start{column, row, 0};
    Walker at = start;
    runs.push_back({Vector2d(at.x, at.y), at.way, 0});
    do {
      if (at.way == 0) walked_[index(at.x, at.y)] = true;
      at.x += kDx[at.way];
      at.y += kDy[at.way];
      ++runs.back().length;
      const int before = at.way;
      // To the right first: cells that touch at a corner belong together.
      if (is_occupied_ahead(grid_, at, false)) {
        at.way = (at.way + 3) % 4;
      } else if (!is_occupied_ahead(grid_, at, true)) {
        at.way = (at.way + 1) % 4;
      }
      if (at.way != before && at != start) runs.push_back({Vector2d(at.x, at.y), at.way, 0});
    } while (at != start);
  }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid_.num_columns) +
           static_cast<std::size_t>(column);
  }

  const OccupiedCells& grid_;
  std::vector<bool> walked_;  // lower sides of cells, each on one outline
};

// Whether a run is a step of a slanting wall: one cell long, between a turn to one side and one to the other.
bool is_step(const std::vector<Run>& runs, std::size_t i) {
  const Run& run = runs[i];
  const Run& before = runs[(i + runs.size() - 1) % runs.size()];
  const Run& behind = runs[(i + 1) % runs.size()];
  return run.length == 1 && (run.way - before.way + 4) % 4 != (behind.way - run.way + 4) % 4;
}

Outline corners_of(const std::vector<Run>& runs) {
  Outline outline;
  for (const Run& run : runs) outline.push_back(run.from);
  return outline;
}

Outline without_steps(const std::vector<Run>& runs) {
  Outline outline;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Run& run = runs[i];
    const bool is_step_here = is_step(runs, i);
    if (!is_step_here && !is_step(runs, (i + runs.size() - 1) % runs.size())) outline.push_back(run.from);
    if (is_step_here) outline.push_back(run.from + 0.5 * Vector2d(kDx[run.way], kDy[run.way]));
  }
  return outline.size() < 3 ? corners_of(runs) : outline;
}

/// Directions from one point in which a straight wall passes all points since it within the tolerance.
class Cone {
 public:
  explicit Cone(const Vector2d& apex) : apex_(apex) {}

  /// Narrows the cone to the point. @returns false where a wall to it would miss a point before.
  bool take(const Vector2d& point) {
    const Vector2d way = point - apex_;
    const double length = way.norm();
    if (length < farthest_ - kTolerance) return false;  // it comes back
    farthest_ = std::max(farthest_, length);
    if (length <= kTolerance) return true;
    const double direction_rad = std::atan2(way.y(), way.x());
    const double spread_rad = std::asin(kTolerance / length);
    if (!is_open_) {
      is_open_ = true;
      middle_rad_ = direction_rad;
      least_rad_ = -spread_rad;
      greatest_rad_ = spread_rad;
      return true;
    }
    const double off_rad = wrap_to_pi(direction_rad - middle_rad_);
    if (off_rad < least_rad_ || off_rad > greatest_rad_) return false;
    least_rad_ = std::max(least_rad_, off_rad - spread_rad);
    greatest_rad_ = std::min(greatest_rad_, off_rad + spread_rad);
    return true;
  }

 private:
  Vector2d apex_;
  double farthest_ = 0.0;
  bool is_open_ = false;
  double middle_rad_ = 0.0;
  double least_rad_ = 0.0;  // from the middle
  double greatest_rad_ = 0.0;
};

// Straight walls as long as they can be, from the first point round to it again. Linear in time, where
// splitting at the farthest point would be quadratic at worst.
Outline straightened(const Outline& outline) {
  Outline straight = {outline.front()};
  Cone cone(outline.front());
  for (std::size_t i = 1; i <= outline.size(); ++i) {
    const Vector2d& point = outline[i % outline.size()];
    if (cone.take(point)) continue;
    straight.push_back(outline[i - 1]);
    cone = Cone(outline[i - 1]);
    cone.take(point);
  }
  return straight.size() < 3 ? outline : straight;
}

}  // namespace

std::vector<Outline> trace_outlines(const OccupiedCells& grid, std::size_t max_points) {
  Tracer tracer(grid);
  std::vector<Outline> outlines;
  std::vector<Run> runs;
  std::size_t num_points = 0;
  for (int row = 0; row < grid.num_rows; ++row) {
    for (int column = 0; column < grid.num_columns; ++column) {
      if (!tracer.is_new_lower_side(column, row)) continue;
      tracer.walk(column, row, runs);
      outlines.push_back(straightened(without_steps(runs)));
      num_points += outlines.back().size();
      if (num_points > max_points) {
        throw InputError("more than " + std::to_string(max_points) +
                         " walls; allowed: that many; coarser or cleaner maps have fewer");
      }
    }
  }
  return outlines;
}

}  // namespace scanbed::sim
