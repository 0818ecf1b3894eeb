// SPDX-License-Identifier: MIT
#include "core/score/wall_pieces.hpp"

#include <algorithm>

namespace scanbed {
namespace {

constexpr int kMinBeams = 6;
constexpr double kMinLength_m = 0.3;
constexpr int kMaxBridgedBeams = 3;

}  // namespace

bool WallPiece::is_resolvable() const {
  return num_beams >= kMinBeams && length_m() >= kMinLength_m;
}

Eigen::Vector2d true_point_m(const Truth& truth, const LaserScan& scan, int beam) {
  const double bearing_rad = scan.geometry.bearing_rad(beam);
  return truth.beams[beam].range_m * Eigen::Vector2d(std::cos(bearing_rad), std::sin(bearing_rad));
}

std::vector<WallPiece> visible_wall_pieces(const Truth& truth, const LaserScan& scan) {
  std::vector<WallPiece> pieces;
  std::vector<int> open_piece(truth.objects.size(), -1);  // of each object: index into pieces
  for (int i = 0; i < scan.num_beams(); ++i) {
    const int object = truth.beams[i].object;
    if (object == kNoObject || !scan.has_echo(i)) continue;
    if (truth.objects[object].primitive != Primitive::kLine) continue;
    const Eigen::Vector2d p_m = true_point_m(truth, scan, i);
    int& open = open_piece[object];
    if (open < 0 || i - pieces[open].beams.last > kMaxBridgedBeams + 1) {
      open = static_cast<int>(pieces.size());
      pieces.push_back({object, {i, i}, 0, p_m, p_m});
    }
    pieces[open].beams.last = i;
    pieces[open].to_m = p_m;
    ++pieces[open].num_beams;
  }
  return pieces;
}

}  // namespace scanbed
