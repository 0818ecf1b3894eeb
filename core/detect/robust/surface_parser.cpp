// SPDX-License-Identifier: MIT
#include "core/detect/robust/surface_parser.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace scanbed {
namespace {

constexpr int kMinJoinedEchoes = 2;  // of a surface that may be a column's part
// Between two parts of a column: beams without a nearer echo say that nothing hides its middle.
constexpr int kMaxLostBeams = 2;
// Surfaces that are tried as its second part: a scan of many steps towards the sensor has no end of them.
constexpr std::size_t kMaxSurfacesBetween = 16;

}  // namespace

void SurfaceParser::parse(Echoes& echoes, const LaserScan& scan, const DetectorOptions& options,
                          Features& features) {
  options_ = &options;
  splitter_.split(echoes, options.surface, runs_);
  sums_.build(echoes);
  surfaces_.clear();
  pieces_.clear();
  arcs_.clear();
  const SurfacedScan surfaced{scan, echoes};
  line_splitter_.begin(echoes, sums_, options.surface);
  arc_finder_.begin(surfaced, sums_, options);
  for (int i = 0; i < runs_.num_runs(); ++i) line_splitter_.add(runs_.run(i));
  line_splitter_.split();
  for (int i = 0; i < runs_.num_runs(); ++i) {
    if (runs_.run(i).size() >= kMinJoinedEchoes) explain(runs_.run(i));
  }
  join_across_occluders(surfaced);
  for (const Arc& arc : arcs_) {
    if (arc.gain <= arc.doubt) continue;
    const bool has_enough = arc.num_echoes() >= options.circle.min_points;
    report_arc(surfaced, arc, has_enough ? features.circles : features.doubtful_circles);
  }
  // Only now: arcs are told by what lines leave of them, however they are cut.
  for (const Explained& surface : surfaces_) {
    line_splitter_.settle_cuts(pieces_of(surface));
    for (int i = 0; i < surface.num_arcs; ++i) take_rests(echoes, surface, arcs_[surface.first_arc + i]);
  }
  wall_lines_.begin(echoes, sums_, options);
  wall_lines_.append(pieces_, features.lines);
}

void SurfaceParser::explain(Stretch surface) {
  Explained explained{.places = surface,
                      .first_piece = static_cast<int>(pieces_.size()),
                      .first_arc = static_cast<int>(arcs_.size())};
  line_splitter_.append_pieces(surface, pieces_);
  explained.num_pieces = static_cast<int>(pieces_.size()) - explained.first_piece;
  if (surface.size() >= arc_finder_.min_echoes()) arc_finder_.find(surface, pieces_of(explained), arcs_);
  explained.num_arcs = static_cast<int>(arcs_.size()) - explained.first_arc;
  surfaces_.push_back(explained);
}

std::span<LinePiece> SurfaceParser::pieces_of(const Explained& surface) {
  return std::span<LinePiece>(pieces_).subspan(surface.first_piece, surface.num_pieces);
}

void SurfaceParser::join_across_occluders(const SurfacedScan& scan) {
  const std::size_t num_surfaces = surfaces_.size();
  for (std::size_t i = 0; i < num_surfaces; ++i) {
    const int last = surfaces_[i].places.last;
    HiddenBeams hidden{.last = scan.echoes.beam[last]};
    // Behind most surfaces the next beam already sees farther.
    if (!is_hidden_before(scan, last, std::min(hidden.last + 2, scan.scan.num_beams()), hidden)) continue;
    const std::size_t end = std::min(num_surfaces, i + 1 + kMaxSurfacesBetween);
    for (std::size_t j = i + 1; j < end; ++j) {
      const int first_beam = scan.echoes.beam[surfaces_[j].places.first];
      if (!is_hidden_before(scan, last, first_beam, hidden)) break;
      if (may_go_on(scan, surfaces_[i], surfaces_[j]) && join(surfaces_[i], surfaces_[j])) break;
    }
  }
}

// Whether all beams behind an echo, up to the one before the given beam, met something nearer than it.
bool SurfaceParser::is_hidden_before(const SurfacedScan& scan, int echo, int beam, HiddenBeams& hidden) {
  for (; hidden.last + 1 < beam; ++hidden.last) {
    const double range_m = scan.scan.range_m[hidden.last + 1];
    if (range_m < scan.echoes.range_m[echo]) continue;
    if (std::isfinite(range_m) || ++hidden.num_lost > kMaxLostBeams) return false;
  }
  return true;
}

// Whether both may be parts of one column whose middle is hidden: near enough to each other, and all between
// them is nearer.
bool SurfaceParser::may_go_on(const SurfacedScan& scan, const Explained& before,
                              const Explained& after) const {
  const Echoes& e = scan.echoes;
  const int last = before.places.last;
  const int first = after.places.first;
  if (e.beam[first] <= e.beam[last] + 1) return false;
  const auto are_near = [&](int a, int b) {
    const double widest_m = 2.0 * options_->surface.max_radius_m;
    return (e.point_m(a) - e.point_m(b)).squaredNorm() <= widest_m * widest_m;
  };
  if (!are_near(first, before.places.first) || !are_near(last, after.places.last)) return false;
  for (int beam = e.beam[last] + 1; beam < e.beam[first]; ++beam) {
    if (scan.scan.has_echo(beam) && scan.scan.range_m[beam] >= e.range_m[first]) return false;
  }
  return true;
}

bool SurfaceParser::join(Explained& before, Explained& after) {
  if (!arc_finder_.may_join(before.places, after.places)) return false;
  const double as_line = options_->surface.line_price + sums_.fit_both(before.places, after.places).chi2;
  const double cost = std::min(cost_of(before) + cost_of(after), as_line);
  const auto arc = arc_finder_.join(before.places, after.places, cost);
  if (!arc) return false;
  release(before);
  release(after);
  arcs_.push_back(*arc);
  return true;
}

double SurfaceParser::cost_of(const Explained& surface) {
  double cost = 0.0;
  for (const LinePiece& piece : pieces_of(surface)) cost += piece.cost;
  for (int i = 0; i < surface.num_arcs; ++i) cost -= arcs_[surface.first_arc + i].gain;
  return cost;
}

void SurfaceParser::release(Explained& surface) {
  for (LinePiece& piece : pieces_of(surface)) piece.is_taken = true;
  constexpr double kNeverSure = std::numeric_limits<double>::infinity();
  for (int i = 0; i < surface.num_arcs; ++i) arcs_[surface.first_arc + i].doubt = kNeverSure;
}

// An arc is made of whole pieces, and of so many at most. What is left beside it is no line where the arc as
// it is explains it at less cost.
void SurfaceParser::take_rests(const Echoes& echoes, const Explained& surface, const Arc& arc) {
  if (arc.gain <= arc.doubt) return;
  const std::span<LinePiece> pieces = pieces_of(surface);
  const auto is_rest = [&](const LinePiece& piece) {
    double left = options_->surface.line_price + piece.chi2;
    for (int k = piece.places.first; k <= piece.places.last && left >= 0.0; ++k) {
      left -= arc.fit.squared_residual(echoes, k);
    }
    return left >= 0.0;
  };
  const auto take = [&](auto piece, const auto& end) {
    for (; piece != end && (piece->is_taken || is_rest(*piece)); ++piece) piece->is_taken = true;
  };
  const auto ends_behind = [](const LinePiece& piece, int place) { return piece.places.last < place; };
  const auto first =
      std::lower_bound(pieces.begin(), pieces.end(), arc.parts[0].first, ends_behind);  // of the arc
  take(first, pieces.end());
  take(std::make_reverse_iterator(first), pieces.rend());
}

void SurfaceParser::report_arc(const SurfacedScan& scan, const Arc& arc, std::vector<Circle>& circles) const {
  Circle circle;
  circle.beams = {scan.echoes.beam[arc.parts[0].first], scan.echoes.beam[arc.last_part().last]};
  circle.center_m = arc.fit.cylinder.center_m;
  circle.radius_m = arc.fit.cylinder.radius_m;
  circle.score = 1.0 - std::exp(-0.1 * (arc.gain - arc.doubt));
  circle.covariance = arc.fit.covariance();
  circles.push_back(circle);
}

}  // namespace scanbed
