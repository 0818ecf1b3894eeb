// SPDX-License-Identifier: MIT
#include "core/interpret/piece_order.hpp"

#include <cmath>

#include "core/detect/full_turn.hpp"

namespace scanbed {

PieceOrder::PieceOrder(const LaserScan& scan, int num_pieces)
    : scan_(scan), num_pieces_(num_pieces), num_in_turn_(num_beams_in_turn(scan)) {}

BeamSpan PieceOrder::between(const Line& a, const Line& b) const {
  if (num_in_turn_ == 0) return {a.beams.last + 1, b.beams.first - 1};
  const int last = last_beam(a);
  const int most_shared = num_in_turn_ / 8;  // b may begin before a ends, but by no more
  const int num_turned = (first_beam(b) - last + most_shared + num_in_turn_) % num_in_turn_;
  return {last + 1, last + num_turned - most_shared - 1};
}

// Of a piece that lies across the seam the beams are those of its larger part; its ends are all of it.
int PieceOrder::first_beam(const Line& piece) const {
  return piece.beams.first > 0 ? piece.beams.first : beam_towards(piece.left_m);
}

int PieceOrder::last_beam(const Line& piece) const {
  return piece.beams.last < num_in_turn_ - 1 ? piece.beams.last : beam_towards(piece.right_m);
}

int PieceOrder::beam_towards(const Eigen::Vector2d& p_m) const {
  const double beam = scan_.geometry.beam_towards(std::atan2(p_m.y(), p_m.x()));
  return static_cast<int>(std::lround(beam) + num_in_turn_) % num_in_turn_;
}

}  // namespace scanbed
