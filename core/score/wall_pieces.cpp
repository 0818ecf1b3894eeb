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

const std::vector<WallPiece>& WallPieceFinder::find(const Truth& truth, const LaserScan& scan) {
  pieces_.clear();
  pieces_.reserve(truth.beams.size());  // as many as there can be, so that no later scan finds it too small
  open_piece_.assign(truth.objects.size(), -1);
  for (int i = 0; i < scan.num_beams(); ++i) {
    const int object = truth.beams[i].object;
    if (object == kNoObject || !scan.has_echo(i)) continue;
    if (truth.objects[object].primitive != Primitive::kLine) continue;
    int& open = open_piece_[object];
    if (open < 0 || i - pieces_[open].beams.last > kMaxBridgedBeams + 1) {
      open = static_cast<int>(pieces_.size());
      pieces_.push_back({.object = object, .beams = {i, i}});
    }
    pieces_[open].beams.last = i;
    ++pieces_[open].num_beams;
  }
  for (WallPiece& piece : pieces_) {
    piece.from_m = true_point_m(truth, scan, piece.beams.first);
    piece.to_m = true_point_m(truth, scan, piece.beams.last);
  }
  return pieces_;
}

std::vector<WallPiece> visible_wall_pieces(const Truth& truth, const LaserScan& scan) {
  WallPieceFinder finder;
  finder.find(truth, scan);
  return finder.take();
}

}  // namespace scanbed
