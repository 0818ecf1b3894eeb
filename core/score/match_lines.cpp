// SPDX-License-Identifier: MIT
#include "core/score/match_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/cross.hpp"
#include "core/score/wall_pieces.hpp"

namespace scanbed {
namespace {

using Interval = std::pair<double, double>;

// A wall as an axis: positions along it, offsets across it.
struct WallAxis {
  Eigen::Vector2d origin_m;
  Eigen::Vector2d direction;

  explicit WallAxis(const ObjectTruth& wall)
      : origin_m(wall.from_m), direction((wall.to_m - wall.from_m).normalized()) {}

  double along_m(const Eigen::Vector2d& p_m) const { return direction.dot(p_m - origin_m); }
  double offset_m(const Eigen::Vector2d& p_m) const { return std::abs(cross(direction, p_m - origin_m)); }
  Interval interval(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m) const {
    return std::minmax({along_m(a_m), along_m(b_m)});
  }
};

bool lies_on(const Line& line, const WallAxis& wall, const MatchOptions& options) {
  const Eigen::Vector2d direction = (line.right_m - line.left_m).normalized();
  const double sine = cross(direction, wall.direction);
  return std::abs(sine) <= std::sin(options.line_angle_rad) &&
         wall.offset_m((line.left_m + line.right_m) / 2) <= options.line_offset_m;
}

Interval intersection(const Interval& a, const Interval& b) {
  return {std::max(a.first, b.first), std::min(a.second, b.second)};
}

double total_length_m(std::vector<Interval>& parts) {
  std::sort(parts.begin(), parts.end());
  double total_m = 0.0;
  double covered_to_m = parts.empty() ? 0.0 : parts.front().first;
  for (const auto& [from_m, to_m] : parts) {
    total_m += std::max(0.0, to_m - std::max(from_m, covered_to_m));
    covered_to_m = std::max(covered_to_m, to_m);
  }
  return total_m;
}

// What the pieces say of one detected line.
struct Evidence {
  double on_resolvable_m = 0.0;  // length of the line that covers resolvable pieces of walls it lies on
  double on_marginal_m = 0.0;
  double offset_m = 0.0;  // across the wall of the piece that it covers most
  double most_m = 0.0;
};

// Beams of the line that met marginal pieces, as a share: a bad fit to what need not be found is no error.
double marginal_ratio(const Line& line, const std::vector<WallPiece>& pieces, const Truth& truth) {
  int num_marginal = 0;
  for (const WallPiece& piece : pieces) {
    if (piece.is_resolvable()) continue;
    const int last = std::min(line.beams.last, piece.beams.last);
    for (int i = std::max(line.beams.first, piece.beams.first); i <= last; ++i) {
      if (truth.beams[i].object == piece.object) ++num_marginal;
    }
  }
  return static_cast<double>(num_marginal) / (line.beams.last - line.beams.first + 1);
}

class LineMatcher {
 public:
  LineMatcher(const std::vector<Line>& lines, const LaserScan& scan, const Truth& truth,
              const MatchOptions& options)
      : lines_(lines), truth_(truth), options_(options), pieces_(visible_wall_pieces(truth, scan)) {}

  void count(KindScore& score) {
    evidence_.assign(lines_.size(), {});
    for (const WallPiece& piece : pieces_) count_piece(piece, score);
    for (std::size_t i = 0; i < lines_.size(); ++i) count_line(lines_[i], evidence_[i], score.tally);
  }

 private:
  void count_piece(const WallPiece& piece, KindScore& score) {
    const ObjectTruth& object = truth_.objects[piece.object];
    if ((object.to_m - object.from_m).squaredNorm() == 0.0) return;
    const WallAxis wall(object);
    const Interval piece_m = wall.interval(piece.from_m, piece.to_m);
    std::vector<Interval> covered;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (!lies_on(lines_[i], wall, options_)) continue;
      const Interval common = intersection(piece_m, wall.interval(lines_[i].left_m, lines_[i].right_m));
      if (common.second <= common.first) continue;
      covered.push_back(common);
      add_evidence(common.second - common.first, piece.is_resolvable(),
                   wall.offset_m((lines_[i].left_m + lines_[i].right_m) / 2), evidence_[i]);
    }
    if (!piece.is_resolvable()) return;
    const bool found = total_length_m(covered) >= options_.line_overlap_ratio * piece.length_m();
    score.count_truth(((piece.from_m + piece.to_m) / 2).norm(), found);
  }

  static void add_evidence(double common_m, bool resolvable, double offset_m, Evidence& evidence) {
    (resolvable ? evidence.on_resolvable_m : evidence.on_marginal_m) += common_m;
    if (common_m > evidence.most_m) {
      evidence.most_m = common_m;
      evidence.offset_m = offset_m;
    }
  }

  void count_line(const Line& line, const Evidence& evidence, Tally& tally) const {
    const double needed_m = options_.line_overlap_ratio * (line.right_m - line.left_m).norm();
    const bool right =
        evidence.on_resolvable_m > 0.0 && evidence.on_resolvable_m + evidence.on_marginal_m >= needed_m;
    if (right) {
      ++tally.num_detections;
      ++tally.num_right;
      tally.sum_squared_error_m2 += evidence.offset_m * evidence.offset_m;
    } else if (evidence.on_marginal_m >= needed_m || marginal_ratio(line, pieces_, truth_) > 0.5) {
      ++tally.num_neither;
    } else {
      ++tally.num_detections;
    }
  }

  const std::vector<Line>& lines_;
  const Truth& truth_;
  const MatchOptions& options_;
  std::vector<WallPiece> pieces_;
  std::vector<Evidence> evidence_;  // of each line
};

}  // namespace

KindScore match_lines(const std::vector<Line>& lines, const LaserScan& scan, const Truth& truth,
                      const MatchOptions& options) {
  KindScore score;
  LineMatcher(lines, scan, truth, options).count(score);
  return score;
}

}  // namespace scanbed
