// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/detect/detector_options.hpp"
#include "core/detect/features.hpp"
#include "core/detect/robust/arc_fit.hpp"
#include "core/detect/robust/echoes.hpp"
#include "core/detect/robust/ray_line.hpp"
#include "core/detect/robust/surface_runs.hpp"

namespace scanbed {

/// Explains each surface of a scan by straight pieces and arcs: splits it into lines, merges what one line
/// explains, and takes neighbouring pieces for an arc where that explains them at less cost.
///
/// Models are compared by chi squared in units of range noise plus a price per piece (SurfaceOptions).
class SurfaceParser {
 public:
  /// Appends the lines and circles of all surfaces, unsorted.
  void parse(const Echoes& echoes, const LaserScan& scan, const DetectorOptions& options, Features& features);

 private:
  /// Places [first, last] of the order, explained by a line.
  struct Piece {
    int first = 0;
    int last = 0;
    RayLine line;
    double cost = 0.0;
    bool is_taken = false;  ///< by an arc

    int num_echoes() const { return last - first + 1; }
  };
  /// Places of the order that belong to one surface, both ends included.
  struct Surface {
    int first = 0;
    int last = 0;
  };
  /// Pieces [first_piece, last_piece] of a surface as one arc.
  struct Arc {
    int first_piece = 0;
    int last_piece = 0;
    int first = 0;  ///< places of the order that it keeps
    int last = 0;
    ArcFit fit;
    double price = 0.0;
    double gain = 0.0;  ///< what it saves against lines
  };
  enum class EndKind {
    kFree,      ///< the next beam passes by and sees farther
    kHidden,    ///< something nearer, or the edge of view, may hide the rest
    kAttached,  ///< the surface goes on
  };
  struct End {
    EndKind kind;
    Witness witness;  ///< of a free end
  };

  void parse_surface(const Surface& surface);
  void split_into_lines(int first, int last);
  int best_split(int first, int last) const;
  int climb_to_best_split(int first, int last, int split) const;
  void merge_lines();
  Piece piece_of(int first, int last) const;

  void find_arcs(const Surface& surface);
  std::optional<Arc> try_arc(int first_piece, int last_piece, const Surface& surface) const;
  bool bulges(const Arc& arc) const;
  bool fit_trimmed(Arc& arc, const Surface& surface) const;
  bool fit_between_ends(Arc& arc, const Surface& surface) const;
  bool drop_mixed_ends(Arc& arc) const;
  double arc_in_view_rad(const Arc& arc) const;
  End end_at(int place, int direction, const Surface& surface) const;

  void report_lines(Features& features) const;
  Line line_of(const Piece& piece) const;
  void report_arc(const Arc& arc, Features& features) const;

  double max_chi2(int num_echoes) const;

  const Echoes* echoes_ = nullptr;
  const LaserScan* scan_ = nullptr;
  const DetectorOptions* options_ = nullptr;
  SurfaceSplitter splitter_;
  SurfaceRuns runs_;
  RayLineSums sums_;
  std::vector<Piece> pieces_;
  std::vector<Arc> arcs_;
  std::vector<std::pair<int, int>> pending_;
};

}  // namespace scanbed
