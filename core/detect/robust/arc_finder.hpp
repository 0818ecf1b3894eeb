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

namespace scanbed {

/// Echoes explained by a cylinder, in one part or, where something stands before its middle, in two.
struct Arc {
  std::array<Stretch, 2> parts;  ///< places that it keeps
  int num_parts = 1;
  ArcFit fit;
  double price = 0.0;
  double doubt = 0.0;  ///< what it has to gain beyond 0 to be worth reporting
  double gain = 0.0;   ///< what it saves against lines

  Stretch& last_part() { return parts[num_parts - 1]; }
  const Stretch& last_part() const { return parts[num_parts - 1]; }
  int num_echoes() const;
};

/// A scan with its echoes sorted by surface.
struct SurfacedScan {
  const LaserScan& scan;
  const Echoes& echoes;
  const std::vector<int>& order;
};

/// Looks for arcs that explain a surface at less cost than lines do.
class ArcFinder {
 public:
  /// Appends the arcs of one surface that gain, the best where they contend, and marks the pieces they take.
  void find(const SurfacedScan& scan, Stretch surface, const DetectorOptions& options,
            std::span<LinePiece> pieces, std::vector<Arc>& arcs);

  /// One arc through two surfaces with something nearer between them.
  ///
  /// @param cost  of explaining the two otherwise. @returns the arc where it gains against that.
  std::optional<Arc> join(const SurfacedScan& scan, Stretch before, Stretch after,
                          const DetectorOptions& options, double cost);

 private:
  /// Contenders of one surface: pieces [first_piece, last_piece] as one arc.
  struct Contender {
    int first_piece = 0;
    int last_piece = 0;
    Arc arc;
  };

  bool is_part_of_contender(int first_piece, int last_piece) const;
  bool try_pieces(const SurfacedScan& scan, Stretch surface, std::span<const LinePiece> pieces,
                  Contender& contender);
  bool bulges(const SurfacedScan& scan, Stretch places) const;
  bool fit_trimmed(const SurfacedScan& scan, Stretch surface, Arc& arc);
  bool fit_between_ends(const SurfacedScan& scan, Stretch surface, Arc& arc);
  bool drop_mixed_ends(const SurfacedScan& scan, Arc& arc) const;
  bool is_plausible(const Arc& arc) const;

  const DetectorOptions* options_ = nullptr;
  ArcMoments moments_;
  bool has_moments_ = false;
  std::vector<Contender> contenders_;
  std::vector<int> members_;
};

}  // namespace scanbed
