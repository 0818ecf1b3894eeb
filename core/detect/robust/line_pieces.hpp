// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/robust/echoes.hpp"
#include "core/detect/robust/ray_line.hpp"
#include "core/detect/robust/surface_options.hpp"
#include "core/detect/robust/surface_runs.hpp"

namespace scanbed {

/// Part of a surface, explained by a line, or given up where that is cheaper.
struct LinePiece {
  Stretch places;
  RayLine line;
  double cost = 0.0;      ///< chi squared and price
  bool is_taken = false;  ///< explained by an arc instead
};

/// Explains surfaces by straight pieces: splits where two lines fit best, then merges what one line explains
/// at less cost.
class LineSplitter {
 public:
  /// Begins a scan; what it refers to lives as long as surfaces are split.
  void begin(const Echoes& echoes, const RayLineSums& sums, const SurfaceOptions& options);

  /// Appends the pieces of one surface, in rising order.
  void split(Stretch surface, std::vector<LinePiece>& pieces);

 private:
  /// The last place of the first of two pieces, and how much both explain.
  struct Split {
    int place = 0;
    double explained = 0.0;
  };
  static const Split& better_of(const Split& a, const Split& b) { return b.explained > a.explained ? b : a; }

  void split_down(Stretch surface, std::vector<LinePiece>& pieces);
  void merge_up(std::size_t first_piece, std::vector<LinePiece>& pieces) const;
  bool merge_once(std::size_t first_piece, std::vector<LinePiece>& pieces) const;
  LinePiece piece_of(Stretch places) const;
  int best_split(Stretch places) const;
  int farthest_from_chord(Stretch places) const;
  int climb_to_best_split(Stretch places, int farthest) const;
  Split split_at(Stretch places, int place) const;
  Split step(Stretch places, const Split& from, int stride) const;

  const Echoes* echoes_ = nullptr;
  const RayLineSums* sums_ = nullptr;
  const SurfaceOptions* options_ = nullptr;
  std::vector<Stretch> pending_;
};

}  // namespace scanbed
