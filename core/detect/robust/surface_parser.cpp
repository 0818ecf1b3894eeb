// SPDX-License-Identifier: MIT
#include "core/detect/robust/surface_parser.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed {
namespace {

constexpr int kMaxPiecesOfArc = 9;
constexpr double kMinBulgeRatio = 0.03;
constexpr int kMaxMixedBeams = 2;
constexpr int kMaxTrimmed = 4;
constexpr int kMaxTrimRounds = 3;
// What the beams beyond an end of an arc see, against the range of that end.
constexpr double kNearer_m = 0.1;
constexpr double kFarther_m = 0.15;
constexpr double kSameSurface_m = 0.03;
// Below this a line runs along y so nearly that its slope says nothing.
constexpr double kMinCosine = 1e-6;
constexpr double kTrimResidual = 3.0;

}  // namespace

void SurfaceParser::parse(const Echoes& echoes, const LaserScan& scan, const DetectorOptions& options,
                          Features& features) {
  echoes_ = &echoes;
  scan_ = &scan;
  options_ = &options;
  splitter_.split(echoes, options.surface, runs_);
  sums_.build(echoes, runs_.order);
  for (int i = 0; i < runs_.num_runs(); ++i) {
    const int first = runs_.begin[i];
    const int last = runs_.begin[i + 1] - 1;
    if (last - first < 2) continue;
    parse_surface({first, last});
    for (const Arc& arc : arcs_) report_arc(arc, features);
    report_lines(features);
  }
}

double SurfaceParser::max_chi2(int num_echoes) const {
  return options_->surface.max_chi2_per_point * num_echoes + 6.0;
}

void SurfaceParser::parse_surface(const Surface& surface) {
  pieces_.clear();
  arcs_.clear();
  split_into_lines(surface.first, surface.last);
  merge_lines();
  find_arcs(surface);
}

SurfaceParser::Piece SurfaceParser::piece_of(int first, int last) const {
  Piece piece{first, last, {}, 0.0, false};
  const double as_clutter = options_->surface.clutter_price * piece.num_echoes();
  if (last > first) piece.line = sums_.fit(first, last);
  piece.cost =
      last > first ? std::min(as_clutter, options_->surface.line_price + piece.line.chi2) : as_clutter;
  return piece;
}

int SurfaceParser::best_split(int first, int last) const {
  const Eigen::Vector2d from_m = echoes_->point_m(runs_.order[first]);
  const Eigen::Vector2d along_m = echoes_->point_m(runs_.order[last]) - from_m;
  int split = first;
  double farthest = -1.0;
  for (int i = first + 1; i < last; ++i) {
    const Eigen::Vector2d d_m = echoes_->point_m(runs_.order[i]) - from_m;
    const double off = std::abs(along_m.x() * d_m.y() - along_m.y() * d_m.x());
    if (off > farthest) {
      farthest = off;
      split = i;
    }
  }
  return climb_to_best_split(first, last, std::clamp(split, first, last - 1));
}

// To where two lines explain the run best; they are [first, split] and [split + 1, last].
int SurfaceParser::climb_to_best_split(int first, int last, int split) const {
  const auto chi2_at = [&](int s) {
    return (s > first ? sums_.fit(first, s).chi2 : 0.0) + (s + 1 < last ? sums_.fit(s + 1, last).chi2 : 0.0);
  };
  double best = chi2_at(split);
  const auto move_to = [&](int s) {
    if (s < first || s >= last) return false;
    const double chi2 = chi2_at(s);
    if (chi2 >= best) return false;
    best = chi2;
    split = s;
    return true;
  };
  for (int stride = 8; stride >= 1; stride /= 2) {
    while (move_to(split - stride) || move_to(split + stride)) continue;
  }
  return split;
}

void SurfaceParser::split_into_lines(int first, int last) {
  pending_.assign(1, {first, last});
  while (!pending_.empty()) {
    const auto [a, b] = pending_.back();
    pending_.pop_back();
    const int num_echoes = b - a + 1;
    const Piece piece = piece_of(a, b);
    const double expected = num_echoes - 2;
    if (num_echoes <= 3 || piece.line.chi2 < expected + 4.0 * std::sqrt(expected) + 4.0) {
      pieces_.push_back(piece);
      continue;
    }
    const int split = best_split(a, b);
    pending_.push_back({split + 1, b});
    pending_.push_back({a, split});
  }
}

void SurfaceParser::merge_lines() {
  for (bool merged = true; merged;) {
    merged = false;
    for (std::size_t i = 0; i + 1 < pieces_.size(); ++i) {
      const Piece both = piece_of(pieces_[i].first, pieces_[i + 1].last);
      if (both.cost > pieces_[i].cost + pieces_[i + 1].cost) continue;
      pieces_[i] = both;
      pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      merged = true;
    }
  }
}

// Up to two beams beyond the end may be mixed: the witness is the first that sees clearly farther.
SurfaceParser::End SurfaceParser::end_at(int place, int direction, const Surface& surface) const {
  const int echo = runs_.order[place];
  const double end_m = echoes_->range_m[echo];
  const bool goes_on = place + direction >= surface.first && place + direction <= surface.last;
  for (int i = 1; i <= kMaxMixedBeams + 1; ++i) {
    const int beam = echoes_->beam[echo] + i * direction;
    if (beam < 0 || beam >= scan_->num_beams()) return {EndKind::kHidden, {}};
    const double beyond_m = scan_->range_m[beam] - end_m;
    if (beyond_m < -kNearer_m) return {EndKind::kHidden, {}};
    if (beyond_m > kFarther_m) {
      const double bearing_rad = scan_->geometry.bearing_rad(beam);
      return {EndKind::kFree, {std::cos(bearing_rad), std::sin(bearing_rad)}};
    }
    if (goes_on && i == 1 && std::abs(beyond_m) < kSameSurface_m) return {EndKind::kAttached, {}};
  }
  return {goes_on ? EndKind::kAttached : EndKind::kHidden, {}};
}

bool SurfaceParser::fit_between_ends(Arc& arc, const Surface& surface) const {
  const End ends[2] = {end_at(arc.first, -1, surface), end_at(arc.last, 1, surface)};
  Witness witnesses[2];
  std::size_t num_witnesses = 0;
  arc.price = options_->surface.arc_price;
  for (const End& end : ends) {
    if (end.kind == EndKind::kFree) witnesses[num_witnesses++] = end.witness;
    if (end.kind == EndKind::kHidden) arc.price += options_->surface.hidden_end_price;
    if (end.kind == EndKind::kAttached) arc.price += options_->surface.attached_end_price;
  }
  const auto members = std::span<const int>(runs_.order).subspan(arc.first, arc.last - arc.first + 1);
  const auto fit = fit_arc(*echoes_, members, {witnesses, num_witnesses});
  if (!fit) return false;
  arc.fit = *fit;
  const bool all_free = num_witnesses == 2;
  if (!all_free) arc.price += options_->surface.unsure_arc_price;
  if (!all_free && arc_in_view_rad(arc) < options_->surface.shallow_arc_rad)
    arc.price += options_->surface.shallow_arc_price;
  return true;
}

double SurfaceParser::arc_in_view_rad(const Arc& arc) const {
  const auto from_center_rad = [&](int place) {
    const Eigen::Vector2d d_m = echoes_->point_m(runs_.order[place]) - arc.fit.center_m;
    return std::atan2(d_m.y(), d_m.x());
  };
  return std::abs(wrap_to_pi(from_center_rad(arc.first) - from_center_rad(arc.last)));
}

bool SurfaceParser::drop_mixed_ends(Arc& arc) const {
  const auto is_off = [&](int place) {
    return std::abs(arc.fit.residual(*echoes_, runs_.order[place])) > kTrimResidual;
  };
  const int before = arc.last - arc.first;
  while (arc.last - arc.first >= options_->circle.min_points && is_off(arc.first)) ++arc.first;
  while (arc.last - arc.first >= options_->circle.min_points && is_off(arc.last)) --arc.last;
  return arc.last - arc.first < before;
}

bool SurfaceParser::fit_trimmed(Arc& arc, const Surface& surface) const {
  const int num_echoes = arc.last - arc.first + 1;
  for (int round = 0; round < kMaxTrimRounds; ++round) {
    if (!fit_between_ends(arc, surface)) return false;
    if (round + 1 == kMaxTrimRounds || !drop_mixed_ends(arc)) break;
    if (num_echoes - (arc.last - arc.first + 1) > kMaxTrimmed) return false;
  }
  return true;
}

// Quick to see; what does not bulge towards the sensor is no arc.
bool SurfaceParser::bulges(const Arc& arc) const {
  const Eigen::Vector2d a_m = echoes_->point_m(runs_.order[arc.first]);
  const Eigen::Vector2d chord_m = echoes_->point_m(runs_.order[arc.last]) - a_m;
  const Eigen::Vector2d d_m = echoes_->point_m(runs_.order[(arc.first + arc.last) / 2]) - a_m;
  const double side = chord_m.y() * a_m.x() - chord_m.x() * a_m.y();
  const double bulge_m2 = (chord_m.x() * d_m.y() - chord_m.y() * d_m.x()) * (side < 0.0 ? -1.0 : 1.0);
  return bulge_m2 >= kMinBulgeRatio * chord_m.squaredNorm();
}

std::optional<SurfaceParser::Arc> SurfaceParser::try_arc(int first_piece, int last_piece,
                                                         const Surface& surface) const {
  Arc arc{.first_piece = first_piece, .last_piece = last_piece};
  arc.first = pieces_[first_piece].first;
  arc.last = pieces_[last_piece].last;
  const int num_echoes = arc.last - arc.first + 1;
  if (num_echoes < options_->circle.min_points || !bulges(arc) || !fit_trimmed(arc, surface))
    return std::nullopt;
  if (arc.fit.radius_m < options_->surface.min_radius_m || arc.fit.radius_m > options_->surface.max_radius_m)
    return std::nullopt;
  const int num_kept = arc.last - arc.first + 1;
  if (arc.fit.chi2 > max_chi2(num_kept)) return std::nullopt;
  arc.gain = -arc.fit.chi2 - arc.price - options_->surface.clutter_price * (num_echoes - num_kept);
  for (int i = first_piece; i <= last_piece; ++i) arc.gain += pieces_[i].cost;
  if (arc.gain <= 0.0) return std::nullopt;
  return arc;
}

void SurfaceParser::find_arcs(const Surface& surface) {
  const auto num_pieces = static_cast<int>(pieces_.size());
  for (int i = 0; i < num_pieces; ++i) {
    for (int j = i; j < num_pieces && j - i < kMaxPiecesOfArc; ++j) {
      if (const auto arc = try_arc(i, j, surface)) arcs_.push_back(*arc);
    }
  }
  std::sort(arcs_.begin(), arcs_.end(), [](const Arc& a, const Arc& b) { return a.gain > b.gain; });
  const auto taken_already = [&](const Arc& arc) {
    for (int i = arc.first_piece; i <= arc.last_piece; ++i) {
      if (pieces_[i].is_taken) return true;
    }
    for (int i = arc.first_piece; i <= arc.last_piece; ++i) pieces_[i].is_taken = true;
    return false;
  };
  arcs_.erase(std::remove_if(arcs_.begin(), arcs_.end(), taken_already), arcs_.end());
}

void SurfaceParser::report_lines(Features& features) const {
  for (const Piece& piece : pieces_) {
    if (piece.is_taken || piece.num_echoes() < options_->line.min_points) continue;
    if (piece.line.chi2 > max_chi2(piece.num_echoes())) continue;
    const Line line = line_of(piece);
    if ((line.right_m - line.left_m).norm() >= options_->line.min_length_m) features.lines.push_back(line);
  }
}

// Ends and errors on the line that rays see, which weighs grazing echoes rightly.
Line SurfaceParser::line_of(const Piece& piece) const {
  const double distance_m = 1.0 / piece.line.inverse_m.norm();
  const Eigen::Vector2d normal = piece.line.inverse_m * distance_m;
  const auto off_m = [&](int place) { return distance_m - normal.dot(echoes_->point_m(runs_.order[place])); };
  const auto foot_m = [&](int place) {
    return Eigen::Vector2d(echoes_->point_m(runs_.order[place]) + off_m(place) * normal);
  };
  Line line;
  line.beams = {echoes_->beam[runs_.order[piece.first]], echoes_->beam[runs_.order[piece.last]]};
  line.left_m = foot_m(piece.first);
  line.right_m = foot_m(piece.last);
  if (std::abs(normal.y()) > kMinCosine) {
    line.slope = -normal.x() / normal.y();
    line.bias_m = distance_m / normal.y();
  }
  line.num_points = piece.num_echoes();
  for (int i = piece.first; i <= piece.last; ++i) line.error_m = std::max(line.error_m, std::abs(off_m(i)));
  line.score = 1.0 - 2.0 / line.num_points;
  return line;
}

void SurfaceParser::report_arc(const Arc& arc, Features& features) const {
  Circle circle;
  circle.beams = {echoes_->beam[runs_.order[arc.first]], echoes_->beam[runs_.order[arc.last]]};
  circle.center_m = arc.fit.center_m;
  circle.radius_m = arc.fit.radius_m;
  circle.score = 1.0 - std::exp(-0.1 * arc.gain);
  features.circles.push_back(circle);
}

}  // namespace scanbed
