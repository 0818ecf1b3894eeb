// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/detect/detector_options.hpp"
#include "core/detect/robust/arc_ends.hpp"
#include "core/detect/robust/arc_fit.hpp"
#include "core/detect/robust/arc_moments.hpp"
#include "core/detect/robust/echoes.hpp"
#include "core/detect/robust/line_pieces.hpp"
#include "core/detect/robust/ray_line.hpp"

namespace scanbed {

/// Echoes explained by a cylinder, in one part or, where something stands before its middle, in two.
struct Arc {
  std::array<Stretch, 2> parts;  ///< places that it keeps
  int num_parts = 1;
  ArcFit fit;  ///< a start for it, before it is made
  double price = 0.0;
  double doubt = 0.0;  ///< what it has to gain beyond 0 to be worth reporting
  double gain = 0.0;   ///< what it saves against lines

  const Stretch& last_part() const { return parts[num_parts - 1]; }
  int num_echoes() const;
};

/// Looks for arcs that explain a surface at less cost than lines do.
class ArcFinder {
 public:
  /// Begins a scan; what it refers to lives as long as arcs are looked for.
  void begin(const SurfacedScan& scan, const RayLineSums& sums, const DetectorOptions& options);

  /// Surfaces of fewer echoes hold none.
  int min_echoes() const { return min_echoes_; }

  /// Appends the arcs of one surface that gain, the best where they contend, and marks the pieces they take.
  void find(Stretch surface, std::span<LinePiece> pieces, std::vector<Arc>& arcs);

  /// Whether one arc may go through two surfaces: quick to see.
  bool may_join(Stretch before, Stretch after) const;

  /// One arc through two surfaces with something nearer between them.
  ///
  /// @pre          may_join(before, after).
  /// @param cost   of explaining the two otherwise.
  /// @returns the arc where it gains against that.
  std::optional<Arc> join(Stretch before, Stretch after, double cost);

 private:
  /// Contenders of one surface: pieces [first_piece, last_piece] as one arc.
  struct Contender {
    int first_piece = 0;
    int last_piece = 0;
    Arc arc;
  };

  /// What lies beyond the ends of an arc: what they cost, and the beams that pass by.
  struct Ends {
    std::array<Witness, 2> witnesses;
    int num_free = 0;
    int num_hidden = 0;
    double price = 0.0;
  };

  /// Pieces up to the last that may be an arc, and what they cost.
  struct Candidate {
    int last_piece;
    double cost;
  };

  bool is_short(const LinePiece& piece) const;
  void contend(Stretch surface, std::span<const LinePiece> pieces, int first_piece, int last_piece);
  void take_best(std::span<LinePiece> pieces, std::vector<Arc>& arcs);
  bool try_places(Stretch surface, double cost, Arc& arc);
  bool settle(Stretch surface, double cost, Ends ends, Arc& arc);
  bool is_worth_fitting(const std::optional<AlgebraicArc>& algebraic, double most_chi2) const;
  double least_price_of(Stretch surface) const;
  bool may_be_arc(Stretch places, double cost) const;
  Ends ends_of(Stretch surface, const Arc& arc) const;
  bool fit_trimmed(Stretch surface, double cost, Ends& ends, Arc& arc) const;
  bool drop_mixed_ends(Arc& arc) const;
  bool is_plausible(const Arc& arc) const;
  double arc_in_view_rad(const Arc& arc) const;
  double cost_as_line(Stretch places) const;
  double doubt_of(const Ends& ends) const;
  double doubt_of(const Arc& arc, const Ends& ends) const;
  double expected_gain(const Arc& arc) const;
  const Echoes& echoes() const { return scan_->echoes; }
  Eigen::Vector2d point_m(int place) const { return scan_->echoes.point_m(place); }

  std::optional<SurfacedScan> scan_;
  const RayLineSums* sums_ = nullptr;
  const DetectorOptions* options_ = nullptr;
  int min_echoes_ = 0;
  double least_price_ = 0.0;     ///< of an arc on the surface
  double least_chord_m2_ = 0.0;  ///< of a narrow thing
  double narrow_m2_ = 0.0;       ///< squared chord times number of echoes: what has less is narrow
  ArcMoments moments_;
  std::vector<Contender> contenders_;
  int last_explained_piece_ = -1;  ///< by a contender, as well as can be asked
};

}  // namespace scanbed
