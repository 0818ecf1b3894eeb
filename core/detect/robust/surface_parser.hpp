// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/detect/detector_options.hpp"
#include "core/detect/features.hpp"
#include "core/detect/robust/arc_finder.hpp"
#include "core/detect/robust/echoes.hpp"
#include "core/detect/robust/line_pieces.hpp"
#include "core/detect/robust/ray_line.hpp"
#include "core/detect/robust/surface_runs.hpp"
#include "core/detect/robust/wall_lines.hpp"

namespace scanbed {

/// Explains each surface of a scan by straight pieces and arcs: splits it into lines, merges what one line
/// explains, and takes neighbouring pieces for an arc where that explains them at less cost. Then two
/// surfaces with something nearer between them become one arc where that costs less than both.
///
/// Models are compared by chi squared in units of range noise plus a price per piece (SurfaceOptions). An arc
/// that explains a surface better than lines, but not well enough to be sure, is not reported; nor are lines
/// on it: there are no polygons on round things.
class SurfaceParser {
 public:
  /// Appends the lines and circles of all surfaces, unsorted; sorts the echoes by surface.
  void parse(Echoes& echoes, const LaserScan& scan, const DetectorOptions& options, Features& features);

 private:
  /// What explains a surface.
  struct Explained {
    Stretch places;
    int first_piece = 0;  ///< of pieces_
    int num_pieces = 0;
    int first_arc = 0;  ///< of arcs_
    int num_arcs = 0;
  };

  /// The beams behind an echo that met something nearer than it.
  struct HiddenBeams {
    int last = 0;
    int num_lost = 0;  ///< of those without echo
  };

  void explain(Stretch surface);
  void join_across_occluders(const SurfacedScan& scan);
  static bool is_hidden_before(const SurfacedScan& scan, int echo, int beam, HiddenBeams& hidden);
  bool may_go_on(const SurfacedScan& scan, const Explained& before, const Explained& after) const;
  double cost_of(const Explained& surface);
  bool join(Explained& before, Explained& after);
  void release(Explained& surface);
  std::span<LinePiece> pieces_of(const Explained& surface);
  void take_rests(const Echoes& echoes, const Explained& surface, const Arc& arc);
  void report_arc(const SurfacedScan& scan, const Arc& arc, std::vector<Circle>& circles) const;

  const DetectorOptions* options_ = nullptr;
  SurfaceSplitter splitter_;
  SurfaceRuns runs_;
  RayLineSums sums_;
  LineSplitter line_splitter_;
  ArcFinder arc_finder_;
  WallLines wall_lines_;
  std::vector<Explained> surfaces_;
  std::vector<LinePiece> pieces_;
  std::vector<Arc> arcs_;
};

}  // namespace scanbed
