// SPDX-License-Identifier: MIT
#include "core/detect/robust/line_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanbed {

void LineSplitter::split(const Echoes& echoes, const std::vector<int>& order, const RayLineSums& sums,
                         Stretch surface, const SurfaceOptions& options, std::vector<LinePiece>& pieces) {
  echoes_ = &echoes;
  order_ = &order;
  sums_ = &sums;
  options_ = &options;
  const std::size_t first_piece = pieces.size();
  split_down(surface, pieces);
  merge_up(first_piece, pieces);
}

LinePiece LineSplitter::piece_of(Stretch places) const {
  const double as_clutter = options_->clutter_price * places.size();
  if (places.size() < 2) return {places, {}, as_clutter};
  const RayLine line = sums_->fit(places.first, places.last);
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

// The last place of the first of two pieces; the search starts at the point farthest from the chord.
int LineSplitter::best_split(Stretch places) const {
  const Eigen::Vector2d from_m = echoes_->point_m((*order_)[places.first]);
  const Eigen::Vector2d along_m = echoes_->point_m((*order_)[places.last]) - from_m;
  int split = places.first;
  double farthest = -1.0;
  for (int i = places.first + 1; i < places.last; ++i) {
    const Eigen::Vector2d d_m = echoes_->point_m((*order_)[i]) - from_m;
    const double off = std::abs(along_m.x() * d_m.y() - along_m.y() * d_m.x());
    if (off > farthest) {
      farthest = off;
      split = i;
    }
  }
  return climb_to_best_split(places, std::clamp(split, places.first, places.last - 1));
}

int LineSplitter::climb_to_best_split(Stretch places, int split) const {
  const auto chi2_at = [&](int s) {
    return (s > places.first ? sums_->chi2(places.first, s) : 0.0) +
           (s + 1 < places.last ? sums_->chi2(s + 1, places.last) : 0.0);
  };
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (split > places.first && chi2_at(split - 1) < chi2_at(split))
    --split;  // the corner may be on either piece
  double best = chi2_at(split);
  for (int stride = std::clamp(places.size() / 4, 1, 8); stride >= 1;) {
    // The better side, so that a mirrored run is cut at the same place.
    const double before = split - stride >= places.first ? chi2_at(split - stride) : kNone;
    const double after = split + stride < places.last ? chi2_at(split + stride) : kNone;
    if (std::min(before, after) < best) {
      split += before < after ? -stride : stride;
      best = std::min(before, after);
    } else {
      stride /= 2;
    }
  }
  return split;
}

void LineSplitter::merge_up(std::size_t first_piece, std::vector<LinePiece>& pieces) const {
  for (bool merged = true; merged;) {
    merged = false;
    for (std::size_t i = first_piece; i + 1 < pieces.size(); ++i) {
      const LinePiece both = piece_of({pieces[i].places.first, pieces[i + 1].places.last});
      if (both.cost > pieces[i].cost + pieces[i + 1].cost) continue;
      pieces[i] = both;
      pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      merged = true;
    }
  }
}

}  // namespace scanbed
