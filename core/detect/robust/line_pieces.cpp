// SPDX-License-Identifier: MIT
#include "core/detect/robust/line_pieces.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed {
namespace {

constexpr int kMaxExhausted = 8;  // so few echoes are split everywhere to see where it is best

}  // namespace

void LineSplitter::begin(const Echoes& echoes, const RayLineSums& sums, const SurfaceOptions& options) {
  echoes_ = &echoes;
  sums_ = &sums;
  options_ = &options;
}

void LineSplitter::split(Stretch surface, std::vector<LinePiece>& pieces) {
  const std::size_t first_piece = pieces.size();
  split_down(surface, pieces);
  merge_up(first_piece, pieces);
}

LinePiece LineSplitter::piece_of(Stretch places) const {
  const double as_clutter = options_->clutter_price * places.size();
  if (places.size() < 2) return {places, {}, as_clutter};
  const RayLine line = sums_->fit(places);
  return {places, line, std::min(as_clutter, options_->line_price + line.chi2)};
}

void LineSplitter::split_down(Stretch surface, std::vector<LinePiece>& pieces) {
  pending_.assign(1, surface);
  while (!pending_.empty()) {
    const Stretch places = pending_.back();
    pending_.pop_back();
    const LinePiece piece = piece_of(places);
    const double expected = places.size() - 2;
    if (places.size() <= 3 || piece.line.chi2 < expected + 4.0 * std::sqrt(expected) + 4.0) {
      pieces.push_back(piece);
      continue;
    }
    const int split = best_split(places);
    pending_.push_back({split + 1, places.last});
    pending_.push_back({places.first, split});
  }
}

// The last place of the first of two pieces. On long stretches the search starts at the point farthest from
// the chord.
int LineSplitter::best_split(Stretch places) const {
  if (places.size() > kMaxExhausted) return climb_to_best_split(places, farthest_from_chord(places));
  Split best{places.first, sums_->explained_by_two(places, places.first)};
  for (int s = places.first + 1; s < places.last; ++s) best = better_of(best, split_at(places, s));
  return best.place;
}

LineSplitter::Split LineSplitter::split_at(Stretch places, int place) const {
  place = std::clamp(place, places.first, places.last - 1);
  return {place, sums_->explained_by_two(places, place)};
}

int LineSplitter::farthest_from_chord(Stretch places) const {
  using Block = Eigen::Array<double, 8, 1>;
  const Eigen::Vector2d from_m = echoes_->point_m(places.first);
  const Eigen::Vector2d along_m = echoes_->point_m(places.last) - from_m;
  const auto off_from = [&](int i) -> Block {
    const auto x_m = Eigen::Map<const Block>(&echoes_->x_m[i]);
    const auto y_m = Eigen::Map<const Block>(&echoes_->y_m[i]);
    return (along_m.x() * (y_m - from_m.y()) - along_m.y() * (x_m - from_m.x())).abs();
  };
  // The block with the largest, then the largest in it. The last block ends with the stretch, which is longer
  // than a block.
  int farthest = places.first;
  double most = -1.0;
  for (int i = places.first; i <= places.last; i += Block::SizeAtCompileTime) {
    const int begin = std::min(i, places.last + 1 - static_cast<int>(Block::SizeAtCompileTime));
    const double most_here = off_from(begin).maxCoeff();
    farthest = most_here > most ? begin : farthest;
    most = std::max(most, most_here);
  }
  const Block off = off_from(farthest);
  int i = 0;
  while (i + 1 < Block::SizeAtCompileTime && off[i] != most) ++i;
  return farthest + i;
}

int LineSplitter::climb_to_best_split(Stretch places, int farthest) const {
  // The corner may be on either piece.
  Split best = better_of(split_at(places, farthest), split_at(places, farthest - 1));
  for (int stride = std::clamp(places.size() / 4, 1, 8); stride > 1; stride /= 2) {
    best = step(places, best, stride);
  }
  while (true) {
    const Split next = step(places, best, 1);
    if (next.place == best.place) return best.place;
    best = next;
  }
}

// The better side, so that a mirrored run is cut at the same place.
LineSplitter::Split LineSplitter::step(Stretch places, const Split& from, int stride) const {
  return better_of(from,
                   better_of(split_at(places, from.place - stride), split_at(places, from.place + stride)));
}

// Each pass moves the pieces that stay to the front.
bool LineSplitter::merge_once(std::size_t first_piece, std::vector<LinePiece>& pieces) const {
  std::size_t last_kept = first_piece;
  for (std::size_t next = first_piece + 1; next < pieces.size(); ++next) {
    LinePiece& kept = pieces[last_kept];
    const LinePiece both = piece_of({kept.places.first, pieces[next].places.last});
    if (both.cost > kept.cost + pieces[next].cost) {
      pieces[++last_kept] = pieces[next];
    } else {
      kept = both;
      // What follows is compared in the next pass, as it would be from the other side.
      if (++next < pieces.size()) pieces[++last_kept] = pieces[next];
    }
  }
  const bool merged = last_kept + 1 < pieces.size();
  pieces.resize(last_kept + 1);
  return merged;
}

void LineSplitter::merge_up(std::size_t first_piece, std::vector<LinePiece>& pieces) const {
  while (merge_once(first_piece, pieces)) {
  }
}

}  // namespace scanbed
