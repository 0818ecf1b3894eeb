// SPDX-License-Identifier: MIT
#include "core/detect/robust/wall_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/simd/double_lanes.hpp"

namespace scanbed {
namespace {

// Directions that are known so well need no care.
constexpr double kSureDirection_rad = radians(1.0);
// Chi squared by which an echo at the end of a piece is beyond a corner rather than on its wall: some 2.5
// sigma.
constexpr double kForeignEnd = 6.0;
// Pieces whose line passes the middle of a short one farther off are other walls. Quick to see.
constexpr double kOtherWall_m = 0.1;
// Pieces to each side that are compared with a short one: a scan may have no end of them.
constexpr std::size_t kMaxPiecesBetween = 16;

bool may_be_line(const Echoes& echoes, const LinePiece& piece, const DetectorOptions& options) {
  const int num_echoes = piece.places.size();
  const Eigen::Vector2d chord_m = echoes.point_m(piece.places.last) - echoes.point_m(piece.places.first);
  // All at once, as each alone is hard to foresee. No line is longer than the chord of its ends.
  return !piece.is_taken & (num_echoes >= options.line.min_points) &
         (piece.chi2 <= options.surface.max_chi2(num_echoes)) &
         (chord_m.squaredNorm() >= options.line.min_length_m * options.line.min_length_m);
}

bool is_sure(const RayLine& line) {
  return line.direction_rad2 <= kSureDirection_rad * kSureDirection_rad;
}

bool passes_near(const RayLine& line, const Eigen::Vector2d& p_m) {
  const double off = line.inverse_m.dot(p_m) - 1.0;
  return off * off <= kOtherWall_m * kOtherWall_m * line.inverse_m.squaredNorm();
}

// Whether two pieces share beams, or directions: in a scan that goes beyond a turn, a piece may see itself.
bool see_the_same(const Echoes& echoes, Stretch a, Stretch b) {
  const int turn = echoes.num_beams_to_same_direction;
  const auto beam = [&](int place) { return static_cast<std::int64_t>(echoes.beam[place]); };
  for (const int shift : {-turn, 0, turn}) {
    if (beam(a.first) <= beam(b.last) + shift && beam(b.first) + shift <= beam(a.last)) return true;
  }
  return false;
}

// The largest distance of echoes to a line, two at a time.
double largest_error_m(const Echoes& echoes, Stretch places, const Eigen::Vector2d& normal,
                       double distance_m) {
  const double* const x_m = echoes.x_m.data();
  const double* const y_m = echoes.y_m.data();
  Doubles largest_m{};
  const auto take = [&](const Doubles& x, const Doubles& y) {
    const Doubles off_m = distance_m - (normal.x() * x + normal.y() * y);
    const Doubles error_m = off_m < 0.0 ? -off_m : off_m;
    largest_m = error_m > largest_m ? error_m : largest_m;
  };
  int k = places.first;
  for (; k < places.last; k += 2) take(lanes_at(x_m + k), lanes_at(y_m + k));
  // The last again, where it is one of a pair.
  take(both_lanes(x_m[places.last]), both_lanes(y_m[places.last]));
  return std::max(largest_m[0], largest_m[1]);
}

// Ends and errors on the line that rays see, which weighs grazing echoes rightly.
Line line_of(const Echoes& echoes, Stretch places, const RayLine& seen) {
  const auto [first, last] = places;
  const double distance_m = 1.0 / seen.inverse_m.norm();
  const Eigen::Vector2d normal = seen.inverse_m * distance_m;
  const auto off_m = [&](int place) {
    return distance_m - (normal.x() * echoes.x_m[place] + normal.y() * echoes.y_m[place]);
  };
  const auto foot_m = [&](int place) {
    return Eigen::Vector2d(echoes.point_m(place) + off_m(place) * normal);
  };
  Line line;
  line.beams = {echoes.beam[first], echoes.beam[last]};
  line.left_m = foot_m(first);
  line.right_m = foot_m(last);
  line.set_equation(line.left_m, {-normal.y(), normal.x()});
  line.num_points = places.size();
  line.error_m = largest_error_m(echoes, places, normal, distance_m);
  line.score = 1.0 - 2.0 / line.num_points;
  line.covariance = seen.covariance();
  return line;
}

}  // namespace

void WallLines::begin(const Echoes& echoes, const RayLineSums& sums, const DetectorOptions& options) {
  echoes_ = &echoes;
  sums_ = &sums;
  options_ = &options;
}

void WallLines::append(std::span<const LinePiece> pieces, std::vector<Line>& lines) {
  collect(pieces);
  const double max_sigma_rad = options_->surface.max_direction_sigma_rad;
  const double max_rad2 = max_sigma_rad * max_sigma_rad;
  const double min_chord_m2 = options_->line.min_length_m * options_->line.min_length_m;
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    RayLine best = walls_[i].line;
    if (!is_sure(best)) best = line_with_others(i);
    if (best.direction_rad2 > max_rad2) continue;
    const Line line = line_of(*echoes_, walls_[i].places, best);
    if ((line.right_m - line.left_m).squaredNorm() >= min_chord_m2) lines.push_back(line);
  }
}

void WallLines::collect(std::span<const LinePiece> pieces) {
  walls_.clear();
  for (const LinePiece& piece : pieces) {
    if (!may_be_line(*echoes_, piece, *options_)) continue;
    walls_.push_back({piece.places, sums_->fit(piece.places)});
    if (!is_sure(walls_.back().line)) drop_foreign_ends(walls_.back());
  }
}

// Echoes beyond a corner turn a short piece, while one of its own is hardly missed.
void WallLines::drop_foreign_ends(Wall& wall) const {
  while (wall.line.chi2 > kForeignEnd && wall.places.size() > options_->line.min_points) {
    const auto [first, last] = wall.places;
    const double behind = sums_->chi2_of({first + 1, last});
    const double before = sums_->chi2_of({first, last - 1});
    if (std::min(behind, before) > wall.line.chi2 - kForeignEnd) return;
    wall.places = behind < before ? Stretch{first + 1, last} : Stretch{first, last - 1};
    wall.line = sums_->fit(wall.places);
  }
}

// Of the pieces that one line explains together with this one at less cost, that which tells most.
RayLine WallLines::line_with_others(std::size_t wall) const {
  const auto& [places, alone] = walls_[wall];
  const Eigen::Vector2d middle_m = 0.5 * (echoes_->point_m(places.first) + echoes_->point_m(places.last));
  RayLine best = alone;
  const std::size_t begin = wall - std::min(wall, kMaxPiecesBetween);
  const std::size_t end = std::min(wall + 1 + kMaxPiecesBetween, walls_.size());
  for (std::size_t i = begin; i < end; ++i) {
    const Wall& other = walls_[i];
    if (!passes_near(other.line, middle_m) || see_the_same(*echoes_, places, other.places)) continue;
    const RayLine both = sums_->fit_both(places, other.places);
    if (both.direction_rad2 >= best.direction_rad2) continue;
    if (both.chi2 <= alone.chi2 + other.line.chi2 + options_->surface.line_price) best = both;
  }
  return best;
}

}  // namespace scanbed
