// SPDX-License-Identifier: MIT
#include "sim/world/rounded_path.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/errors/ensure.hpp"
#include "core/errors/input_error.hpp"
#include "core/text/number_text.hpp"
#include "sim/world/world_limits.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;

constexpr double kSharpTurn_m = 0.15;
constexpr double kSlack_m = 1e-9;  // rounding, where two arcs meet in the middle of an edge

/// An edge of the path as drawn, and what the corner at its end does to it.
struct PathEdge {
  Vector2d from_m;
  double heading_rad = 0.0;
  double length_m = 0.0;
  double turn_rad = 0.0;  ///< at its end; 0 at the end of an open path
};

std::vector<PathEdge> edges_of(const Path& path) {
  const std::size_t num_points = path.points_m.size();
  const std::size_t num_edges = path.loop ? num_points : num_points - 1;
  std::vector<PathEdge> edges;
  for (std::size_t i = 0; i < num_edges; ++i) {
    const Vector2d along = path.points_m[(i + 1) % num_points] - path.points_m[i];
    edges.push_back({path.points_m[i], std::atan2(along.y(), along.x()), along.norm(), 0.0});
  }
  for (std::size_t i = 0; i < num_edges; ++i) {
    const bool last = i + 1 == num_edges;
    if (last && !path.loop) break;
    edges[i].turn_rad = wrap_to_pi(edges[last ? 0 : i + 1].heading_rad - edges[i].heading_rad);
  }
  return edges;
}

// How much of each of its two edges a corner's arc takes away, per radius.
double cut_per_radius(double turn_rad) {
  return std::tan(0.5 * std::abs(turn_rad));
}

}  // namespace

void RoundedPath::add(const Piece& piece) {
  if (piece.length_m <= 0.0) return;
  pieces_.push_back(piece);
  pieces_.back().start_m = length_m_;
  length_m_ += piece.length_m;
}

RoundedPath::RoundedPath(const Path& path) : loop_(path.loop) {
  const std::vector<PathEdge> edges = edges_of(path);
  const bool sharp = path.round_m == 0.0;
  double turn_before_rad = path.loop ? edges.back().turn_rad : 0.0;
  for (const PathEdge& edge : edges) {
    const double cut_before_m = path.round_m * cut_per_radius(turn_before_rad);
    const double cut_behind_m = path.round_m * cut_per_radius(edge.turn_rad);
    const Vector2d along(std::cos(edge.heading_rad), std::sin(edge.heading_rad));
    add({.start_m = 0.0,
         .length_m = edge.length_m - cut_before_m - cut_behind_m,
         .p_WA = edge.from_m + cut_before_m * along,
         .heading_rad = edge.heading_rad,
         .along = along,
         .curvature_per_m = 0.0,
         .sharp_before_rad = sharp ? turn_before_rad : 0.0,
         .sharp_behind_rad = sharp ? edge.turn_rad : 0.0});
    if (!sharp) {
      add({.start_m = 0.0,
           .length_m = path.round_m * std::abs(edge.turn_rad),
           .p_WA = edge.from_m + (edge.length_m - cut_behind_m) * along,
           .heading_rad = edge.heading_rad,
           .along = along,
           .curvature_per_m = std::copysign(1.0 / path.round_m, edge.turn_rad)});
    }
    turn_before_rad = edge.turn_rad;
  }
  SCANBED_ENSURE(!pieces_.empty());
}

Pose2 RoundedPath::pose_at(double distance_m) const {
  double s_m = loop_ ? std::fmod(distance_m, length_m_) : std::clamp(distance_m, 0.0, length_m_);
  if (s_m < 0.0) s_m += length_m_;
  const auto behind = std::upper_bound(pieces_.begin() + 1, pieces_.end(), s_m,
                                       [](double s, const Piece& piece) { return s < piece.start_m; });
  const Piece& piece = *(behind - 1);
  const double along_m = std::min(s_m - piece.start_m, piece.length_m);
  if (piece.curvature_per_m != 0.0) {
    const Vector2d across(-piece.along.y(), piece.along.x());
    const double turned_rad = piece.curvature_per_m * along_m;
    return {piece.p_WA + (std::sin(turned_rad) * piece.along + (1.0 - std::cos(turned_rad)) * across) /
                             piece.curvature_per_m,
            wrap_to_pi(piece.heading_rad + turned_rad)};
  }
  const double zone_m = std::min(kSharpTurn_m, 0.5 * piece.length_m);
  const bool at_start = distance_m >= 0.0 && distance_m < zone_m;  // the first time round, nobody turned yet
  const double before = at_start ? 0.0 : std::max(0.0, 1.0 - along_m / zone_m);
  const double behind_ratio = std::max(0.0, 1.0 - (piece.length_m - along_m) / zone_m);
  const double turn_rad = 0.5 * (behind_ratio * piece.sharp_behind_rad - before * piece.sharp_before_rad);
  return {piece.p_WA + along_m * piece.along, wrap_to_pi(piece.heading_rad + turn_rad)};
}

void validate_path(const Path& path, std::string_view name) {
  const std::string subject = std::string(name) + ": path";
  const auto num_points = path.points_m.size();
  require(num_points >= 2, subject + ": number of points", static_cast<double>(num_points), ">= 2");
  for (const Vector2d& p : path.points_m) {
    require(p.allFinite(), subject + ": coordinate", p.x() + p.y(), "finite");
  }
  const std::vector<PathEdge> edges = edges_of(path);
  double turn_before_rad = path.loop ? edges.back().turn_rad : 0.0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::string edge_name = subject + ": from point " + std::to_string(i);
    require(edges[i].length_m >= kMinEdge_m, edge_name + ": length", edges[i].length_m, ">= 0.001 m");
    const double cut = cut_per_radius(turn_before_rad) + cut_per_radius(edges[i].turn_rad);
    const double room_m = edges[i].length_m / cut;
    const double largest_m = room_m < kSlack_m ? 0.0 : room_m;  // it turns back
    require(path.round_m >= 0.0 && path.round_m <= largest_m + kSlack_m, edge_name + ": round", path.round_m,
            "0 to " + number_text(largest_m) + " m, the largest that fits between its corners");
    turn_before_rad = edges[i].turn_rad;
  }
}

}  // namespace scanbed::sim
