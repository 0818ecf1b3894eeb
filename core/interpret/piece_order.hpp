// SPDX-License-Identifier: MIT
#pragma once

#include "core/detect/features.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// Which pieces of walls come after which, and what is between them. In a scan all around the first ones come
/// after the last ones again.
class PieceOrder {
 public:
  /// Of as many pieces, which rise in beams.first. @param scan  theirs; must outlive this.
  PieceOrder(const LaserScan& scan, int num_pieces);

  /// How many pieces come after this one: in a scan all around all the others.
  int num_after(int piece) const { return num_in_turn_ > 0 ? num_pieces_ - 1 : num_pieces_ - 1 - piece; }

  /// The piece `num` places after this one. @pre  1 <= num <= num_after(piece).
  int after(int piece, int num) const { return (piece + num) % num_pieces_; }

  /// The beams between piece a and the later piece b, none (first > last) where they touch. Beams behind the
  /// seam of a scan all around are counted on from the last one.
  BeamSpan between(const Line& a, const Line& b) const;

 private:
  int first_beam(const Line& piece) const;
  int last_beam(const Line& piece) const;
  int beam_towards(const Eigen::Vector2d& p_m) const;

  const LaserScan& scan_;
  int num_pieces_;
  int num_in_turn_;  // beams; 0 where the scan does not go all around
};

}  // namespace scanbed
