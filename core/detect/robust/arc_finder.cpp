// SPDX-License-Identifier: MIT
#include "core/detect/robust/arc_finder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanbed {
namespace {

constexpr int kMaxPiecesOfArc = 9;
// Fewer echoes say nothing of a round. Of so many the best is made even where a circle needs more: no line
// lies on it.
constexpr int kMinArcEchoes = 5;
constexpr double kMinBulgeRatio = 0.03;
constexpr int kMaxTrimmed = 4;  // of a part
constexpr int kMaxTrimRounds = 3;
constexpr double kTrimResidual = 3.0;
constexpr int kMinPartEchoes = 2;
constexpr double kGoodChi2PerEcho = 1.5;
// The algebraic chi squared of an arc that gains hardly ever exceeds the geometric one by more than this
// factor ...
constexpr double kAlgebraicExcess = 1.1;
// ... but for mixed pixels, which may be dropped where there is enough to gain.
constexpr double kMixedExcess = 1.6;

// An arc of sagitta s has a mean squared deviation of so much s^2 from its line.
constexpr double kArcOffLine = 4.0 / 45.0;
// Sagitta over chord of an arc of 100 degrees: so much of something narrow is in view.
constexpr double kSagittaRatio = 0.233;

// Whether a point between two others bulges towards the sensor. Quick to see; what does not is no arc.
inline bool bulges(const Eigen::Vector2d& first_m, const Eigen::Vector2d& between_m,
                   const Eigen::Vector2d& last_m) {
  const Eigen::Vector2d chord_m = last_m - first_m;
  const Eigen::Vector2d d_m = between_m - first_m;
  const double side = chord_m.y() * first_m.x() - chord_m.x() * first_m.y();
  const double bulge_m2 = chord_m.x() * d_m.y() - chord_m.y() * d_m.x();
  return std::copysign(1.0, side) * bulge_m2 >= kMinBulgeRatio * chord_m.squaredNorm();
}

}  // namespace

int Arc::num_echoes() const {
  return parts[0].size() + (num_parts == 2 ? parts[1].size() : 0);
}

void ArcFinder::begin(const SurfacedScan& scan, const RayLineSums& sums, const DetectorOptions& options) {
  scan_.emplace(scan);
  sums_ = &sums;
  options_ = &options;
  moments_.begin(scan.echoes);
  const SurfaceOptions& o = options.surface;
  least_chord_m2_ = 4.0 * o.min_radius_m * o.min_radius_m;
  const double sigma_m = scan.echoes.range_noise_m / kSagittaRatio;
  min_echoes_ = std::min(kMinArcEchoes, options.circle.min_points);
  narrow_m2_ = std::max(o.arc_price - o.line_price, 0.0) / kArcOffLine * sigma_m * sigma_m;
}

void ArcFinder::find(Stretch surface, std::span<LinePiece> pieces, std::vector<Arc>& arcs) {
  contenders_.clear();
  last_explained_piece_ = -1;
  least_price_ = least_price_of(surface);
  const auto num_pieces = static_cast<int>(pieces.size());
  int end_of_short = 0;  // the first piece from i on that is too long for an arc
  for (int i = 0; i < num_pieces; ++i) {
    end_of_short = std::max(end_of_short, i);
    while (end_of_short < num_pieces && is_short(pieces[end_of_short])) ++end_of_short;
    contend(surface, pieces, i, std::min(end_of_short, i + kMaxPiecesOfArc) - 1);
  }
  if (!contenders_.empty()) take_best(pieces, arcs);
}

// No piece of an arc is longer than a cylinder is thick.
bool ArcFinder::is_short(const LinePiece& piece) const {
  const double thickest_m = 2.0 * options_->surface.max_radius_m;
  return (point_m(piece.places.last) - point_m(piece.places.first)).squaredNorm() <= thickest_m * thickest_m;
}

// What is so narrow that noise hides its depth, so that even a perfect arc would not gain what it costs more
// than a line, is not asked to where it stands free: posts are round more often than they are slats.
double ArcFinder::least_price_of(Stretch surface) const {
  const int num_echoes = surface.size();
  const bool may_be_narrow =
      (least_chord_m2_ * num_echoes < narrow_m2_) & (num_echoes >= options_->circle.min_points);
  if (!may_be_narrow) return options_->surface.arc_price;
  const double chord_m2 = (point_m(surface.last) - point_m(surface.first)).squaredNorm();
  const bool is_narrow = (chord_m2 * num_echoes < narrow_m2_) & (chord_m2 >= least_chord_m2_);
  return is_narrow ? options_->surface.line_price : options_->surface.arc_price;
}

// Quick to see: what costs no more than the least arc, has too few echoes, or does not bulge is none.
inline bool ArcFinder::may_be_arc(Stretch places, double cost) const {
  return (cost > least_price_) & (places.size() >= min_echoes_) &
         bulges(point_m(places.first), point_m((places.first + places.last) / 2), point_m(places.last));
}

// The best contenders become arcs, where they do not share pieces with better ones.
void ArcFinder::take_best(std::span<LinePiece> pieces, std::vector<Arc>& arcs) {
  std::sort(contenders_.begin(), contenders_.end(),
            [](const Contender& a, const Contender& b) { return a.arc.gain > b.arc.gain; });
  for (const Contender& contender : contenders_) {
    const auto taken =
        pieces.subspan(contender.first_piece, contender.last_piece - contender.first_piece + 1);
    if (std::any_of(taken.begin(), taken.end(), [](const LinePiece& piece) { return piece.is_taken; }))
      continue;
    for (LinePiece& piece : taken) piece.is_taken = true;
    arcs.push_back(contender.arc);
  }
}

// Tries the pieces from the first on as one arc: all up to the last, then one less, and so on. What one arc
// explains as well as can be asked is not looked at piece by piece.
void ArcFinder::contend(Stretch surface, std::span<const LinePiece> pieces, int first_piece, int last_piece) {
  if (last_piece <= last_explained_piece_) return;
  const int first = pieces[first_piece].places.first;
  std::array<Candidate, kMaxPiecesOfArc> candidates;
  int num_candidates = 0;
  double cost = 0.0;
  for (int i = first_piece; i <= last_piece; ++i) {
    cost += pieces[i].cost;
    // Written in any case, kept where it may be an arc: a jump would be a guess.
    candidates[num_candidates] = {i, cost};
    num_candidates += may_be_arc({first, pieces[i].places.last}, cost) ? 1 : 0;
  }
  while (num_candidates > 0 && candidates[num_candidates - 1].last_piece > last_explained_piece_) {
    const Candidate& candidate = candidates[--num_candidates];
    Arc arc;
    arc.parts[0] = {first, pieces[candidate.last_piece].places.last};
    if (!try_places(surface, candidate.cost, arc)) continue;
    contenders_.push_back({first_piece, candidate.last_piece, arc});
    if (arc.fit.chi2 <= kGoodChi2PerEcho * arc.num_echoes()) last_explained_piece_ = candidate.last_piece;
  }
}

bool ArcFinder::try_places(Stretch surface, double cost, Arc& arc) {
  const Stretch places = arc.parts[0];
  // The quick algebraic fit first: most fail it even if their ends were free.
  const std::optional<AlgebraicArc> algebraic = moments_.arc(places);
  if (!is_worth_fitting(algebraic, cost - least_price_)) return false;
  const Ends ends = ends_of(surface, arc);
  // What is too short for a line is of use only where it is surely a circle.
  const double min_length_m = options_->line.min_length_m;
  const double chord_m2 = (point_m(places.last) - point_m(places.first)).squaredNorm();
  const double least_gain = chord_m2 < min_length_m * min_length_m ? doubt_of(ends) : 0.0;
  if (!is_worth_fitting(algebraic, cost - ends.price - least_gain)) return false;
  arc.fit.cylinder = algebraic->cylinder;
  return settle(surface, cost, ends, arc);
}

bool ArcFinder::is_worth_fitting(const std::optional<AlgebraicArc>& algebraic, double most_chi2) const {
  const double excess = most_chi2 > options_->surface.clutter_price ? kMixedExcess : kAlgebraicExcess;
  return most_chi2 > 0.0 && algebraic && algebraic->chi2 < excess * most_chi2;
}

bool ArcFinder::may_join(Stretch before, Stretch after) const {
  const auto bulges_at = [&](int place) {
    return bulges(point_m(before.first), point_m(place), point_m(after.last));
  };
  return (before.size() + after.size() >= min_echoes_) & (bulges_at(before.last) | bulges_at(after.first));
}

std::optional<Arc> ArcFinder::join(Stretch before, Stretch after, double cost) {
  Arc arc{.parts = {before, after}, .num_parts = 2};
  const Stretch both{before.first, after.last};
  const Ends ends = ends_of(both, arc);
  const std::optional<AlgebraicArc> algebraic = moments_.arc_of_both(before, after);
  if (!is_worth_fitting(algebraic, cost - ends.price)) return std::nullopt;
  arc.fit.cylinder = algebraic->cylinder;
  if (!settle(both, cost, ends, arc)) return std::nullopt;
  return arc;
}

// Fits an arc and says what it gains against what its echoes cost otherwise.
bool ArcFinder::settle(Stretch surface, double cost, Ends ends, Arc& arc) {
  const int num_echoes = arc.num_echoes();
  const Stretch places = arc.parts[0];
  if (!fit_trimmed(surface, cost, ends, arc) || !is_plausible(arc)) return false;
  if (ends.num_free < 2 && arc.num_parts == 1) cost = std::min(cost, cost_as_line(places));
  arc.price = ends.price;
  const int num_dropped = num_echoes - arc.num_echoes();
  arc.gain = cost - arc.fit.chi2 - arc.price - options_->surface.clutter_price * num_dropped;
  if (arc.gain <= 0.0) return false;
  arc.doubt = doubt_of(arc, ends);
  return true;
}

// Of a line with the echo at one end given up: mixed with what lies beyond it, that alone may look like a
// bend.
double ArcFinder::cost_as_line(Stretch places) const {
  const double behind = sums_->chi2_of({places.first + 1, places.last});
  const double before = sums_->chi2_of({places.first, places.last - 1});
  return options_->surface.line_price + options_->surface.clutter_price + std::min(behind, before);
}

bool ArcFinder::is_plausible(const Arc& arc) const {
  const SurfaceOptions& o = options_->surface;
  return arc.fit.cylinder.radius_m >= o.min_radius_m && arc.fit.cylinder.radius_m <= o.max_radius_m &&
         arc.fit.chi2 <= o.max_chi2(arc.num_echoes());
}

ArcFinder::Ends ArcFinder::ends_of(Stretch surface, const Arc& arc) const {
  const SurfaceOptions& o = options_->surface;
  Ends ends{.witnesses = {}, .num_free = 0, .num_hidden = 0, .price = o.arc_price};
  const auto add = [&](int place, int direction) {
    const ArcEnd end = arc_end_at(*scan_, surface, place, direction);
    if (end.kind == ArcEndKind::kFree) ends.witnesses[ends.num_free++] = end.witness;
    if (end.kind == ArcEndKind::kHidden) ++ends.num_hidden;
    if (end.kind == ArcEndKind::kAttached) ends.price += o.attached_end_price;
  };
  add(arc.parts[0].first, -1);
  add(arc.last_part().last, 1);
  if (ends.num_free == 2 && arc.num_parts == 1) ends.price = least_price_;
  return ends;
}

// Mixed pixels at the ends go, round by round, while what they cost leaves something to gain.
bool ArcFinder::fit_trimmed(Stretch surface, double cost, Ends& ends, Arc& arc) const {
  const SurfaceOptions& o = options_->surface;
  const int num_echoes = arc.num_echoes();
  double most_chi2 = cost - ends.price;
  for (int round = 1;; ++round) {
    const ArcEvidence evidence{std::span(arc.parts).first(arc.num_parts),
                               std::span(ends.witnesses).first(ends.num_free)};
    const auto fit = fit_arc(echoes(), evidence, arc.fit.cylinder, most_chi2);
    if (!fit) return false;
    arc.fit = *fit;
    if (round == kMaxTrimRounds || !drop_mixed_ends(arc)) return true;
    const int num_dropped = num_echoes - arc.num_echoes();
    ends = ends_of(surface, arc);
    most_chi2 = cost - ends.price - o.clutter_price * num_dropped;
    if (num_dropped > kMaxTrimmed * arc.num_parts || most_chi2 <= 0.0) return false;
  }
}

bool ArcFinder::drop_mixed_ends(Arc& arc) const {
  const auto is_off = [&](int place) {
    return arc.fit.squared_residual(echoes(), place) > kTrimResidual * kTrimResidual;
  };
  const int before = arc.num_echoes();
  const int least = arc.num_parts == 1 ? min_echoes_ : kMinPartEchoes;
  for (int part = 0; part < arc.num_parts; ++part) {
    Stretch& places = arc.parts[part];
    while (places.size() > least && is_off(places.first)) ++places.first;
    while (places.size() > least && is_off(places.last)) --places.last;
  }
  return arc.num_echoes() < before;
}

double ArcFinder::arc_in_view_rad(const Arc& arc) const {
  const Eigen::Vector2d a = point_m(arc.parts[0].first) - arc.fit.cylinder.center_m;
  const Eigen::Vector2d b = point_m(arc.last_part().last) - arc.fit.cylinder.center_m;
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

double ArcFinder::doubt_of(const Ends& ends) const {
  const SurfaceOptions& o = options_->surface;
  return ends.num_free == 2 ? 0.0 : o.unsure_arc_price + o.hidden_end_price * ends.num_hidden;
}

double ArcFinder::doubt_of(const Arc& arc, const Ends& ends) const {
  const SurfaceOptions& o = options_->surface;
  double doubt = doubt_of(ends);
  if (ends.num_free < 2 && arc_in_view_rad(arc) < o.shallow_arc_rad) doubt += o.shallow_arc_price;
  return std::max(doubt, std::min(o.doubt_ratio * (expected_gain(arc) - o.doubt_start), o.max_doubt));
}

// What lines would cost on a perfect arc, less what the arc itself costs: how much a true arc gains on
// average. k lines see sagittas of s / k^2.
double ArcFinder::expected_gain(const Arc& arc) const {
  const double sagitta_m = arc.fit.cylinder.radius_m * (1.0 - std::cos(0.5 * arc_in_view_rad(arc)));
  const double sigmas = sagitta_m / std::sqrt(echoes().variance_at_m2(arc.fit.cylinder.center_m.norm()));
  const double as_line = kArcOffLine * sigmas * sigmas * arc.num_echoes();
  double least = std::numeric_limits<double>::infinity();
  for (int k = 1; k <= 4; ++k) {
    least = std::min(least, k * options_->surface.line_price + as_line / (k * k * k * k));
  }
  return std::max(0.0, least - arc.price);
}

}  // namespace scanbed
