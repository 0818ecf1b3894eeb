// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/detect/robust/echoes.hpp"
#include "core/detect/robust/ray_line.hpp"
#include "core/detect/robust/surface_options.hpp"
#include "core/detect/robust/surface_runs.hpp"

namespace scanbed {

/// Part of a surface, explained by a line, or given up where that is cheaper.
struct LinePiece {
  Stretch places;
  double chi2 = 0.0;      ///< of the line
  double cost = 0.0;      ///< chi squared and price
  bool is_taken = false;  ///< explained by an arc instead
};

/// Explains surfaces by straight pieces: splits where two lines fit best, then merges what one line explains
/// at less cost.
///
/// All surfaces of a scan are split side by side, one cut of each part at a time: none waits for another, so
/// that a processor works on some at once.
class LineSplitter {
 public:
  /// Begins a scan; what it refers to lives as long as surfaces are split.
  void begin(const Echoes& echoes, const RayLineSums& sums, const SurfaceOptions& options);

  /// Takes a surface to be split.
  void add(Stretch surface);

  /// Splits the surfaces.
  void split();

  /// Appends the pieces of a surface that is split, in rising order.
  void append_pieces(Stretch surface, std::vector<LinePiece>& pieces);

  /// Cuts were sought while the parts on their sides were not cut themselves: a niche farther on moves a
  /// corner. Seeks each once more, between what of a surface's pieces no arc took.
  void settle_cuts(std::span<LinePiece> pieces);

 private:
  /// Of the part that begins at a place: where it ends, and what the line through it leaves unexplained.
  struct Part {
    int last = 0;
    double chi2 = 0.0;
  };

  void add_part(Stretch places, double chi2);
  void cut_all();
  void climb(Stretch places, int first_cut, RayLineSums::Cut& best) const;
  int first_cut_of(Stretch places) const;
  int far_from_chord(Stretch places) const;
  double cost_of(Stretch places, double chi2) const;
  bool merge_once(std::size_t first_piece, std::vector<LinePiece>& pieces);
  bool compare_pairs(std::span<const LinePiece> pieces);

  const Echoes* echoes_ = nullptr;
  const RayLineSums* sums_ = nullptr;
  const SurfaceOptions* options_ = nullptr;
  std::vector<Part> parts_;      ///< at their first places
  std::vector<Stretch> to_cut_;  ///< parts that no line explains
  int num_to_cut_ = 0;
  std::vector<Stretch> cutting_;  ///< those of them that are being cut
  std::vector<int> first_cuts_;   ///< for each of them: where the best cut is sought
  std::vector<RayLineSums::Cut> cuts_;
  std::vector<LinePiece> pairs_;  ///< of neighbouring pieces: both as one
};

}  // namespace scanbed
