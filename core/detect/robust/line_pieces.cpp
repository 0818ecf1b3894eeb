// SPDX-License-Identifier: MIT
#include "core/detect/robust/line_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanbed {

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

// The last place of the first of two pieces; the search starts at the point farthest from the chord.
int LineSplitter::best_split(Stretch places) const {
  return climb_to_best_split(places, std::clamp(farthest_from_chord(places), places.first, places.last - 1));
}

int LineSplitter::farthest_from_chord(Stretch places) const {
  const Eigen::Vector2d from_m = echoes_->point_m(places.first);
  const Eigen::Vector2d along_m = echoes_->point_m(places.last) - from_m;
  const double* const x_m = echoes_->x_m.data();
  const double* const y_m = echoes_->y_m.data();
  int farthest = places.first;
  double most = -1.0;
  for (int i = places.first + 1; i < places.last; ++i) {
    const double off = std::abs(along_m.x() * (y_m[i] - from_m.y()) - along_m.y() * (x_m[i] - from_m.x()));
    if (off > most) {
      most = off;
      farthest = i;
    }
  }
  return farthest;
}

int LineSplitter::climb_to_best_split(Stretch places, int split) const {
  const auto explained_at = [&](int s) {
    return s >= places.first && s < places.last ? sums_->explained_by_two(places, s)
                                                : -std::numeric_limits<double>::infinity();
  };
  double best = explained_at(split);
  // The corner may be on either piece.
  if (const double before = explained_at(split - 1); before > best) {
    best = before;
    --split;
  }
  int come_from = 0;  // the side on which the last place lies: it is worse
  for (int stride = std::clamp(places.size() / 4, 1, 8); stride >= 1;) {
    // The better side, so that a mirrored run is cut at the same place.
    const double before = come_from < 0 ? best : explained_at(split - stride);
    const double after = come_from > 0 ? best : explained_at(split + stride);
    if (std::max(before, after) > best) {
      const int direction = before > after ? -1 : 1;
      split += direction * stride;
      come_from = -direction;
      best = std::max(before, after);
    } else {
      stride /= 2;
      come_from = 0;
    }
  }
  return split;
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
