// SPDX-License-Identifier: MIT
#include "core/detect/robust/arc_finder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanbed {
namespace {

constexpr int kMaxPiecesOfArc = 9;
constexpr double kMinBulgeRatio = 0.03;
constexpr int kMaxTrimmed = 4;  // of a part
constexpr int kMaxTrimRounds = 3;
constexpr double kTrimResidual = 3.0;
constexpr int kMinPartEchoes = 2;
constexpr double kGoodChi2PerEcho = 1.5;
// The algebraic chi squared may exceed the geometric one by this factor.
constexpr double kAlgebraicExcess = 3.0;

double bearing_from_center_rad(const Eigen::Vector2d& point_m, const ArcFit& fit) {
  const Eigen::Vector2d d_m = point_m - fit.center_m;
  return std::atan2(d_m.y(), d_m.x());
}

double arc_in_view_rad(const SurfacedScan& scan, const Arc& arc) {
  const auto at_rad = [&](int place) {
    return bearing_from_center_rad(scan.echoes.point_m(scan.order[place]), arc.fit);
  };
  return std::abs(wrap_to_pi(at_rad(arc.parts[0].first) - at_rad(arc.last_part().last)));
}

// What lines would cost on a perfect arc, less what the arc itself costs: how much a true arc gains on
// average. An arc of sagitta s has a mean squared deviation of (4/45) s^2 from its line; k lines see sagittas
// of s / k^2.
double expected_gain(const SurfacedScan& scan, const Arc& arc, const SurfaceOptions& options) {
  const double sagitta_m = arc.fit.radius_m * (1.0 - std::cos(0.5 * arc_in_view_rad(scan, arc)));
  const double sigmas = sagitta_m / scan.echoes.range_noise_m;
  const double as_line = 4.0 / 45.0 * sigmas * sigmas * arc.num_echoes();
  double least = std::numeric_limits<double>::infinity();
  for (int k = 1; k <= 4; ++k) least = std::min(least, k * options.line_price + as_line / (k * k * k * k));
  return std::max(0.0, least - arc.price);
}

}  // namespace

int Arc::num_echoes() const {
  return parts[0].size() + (num_parts == 2 ? parts[1].size() : 0);
}

void ArcFinder::find(const SurfacedScan& scan, Stretch surface, const DetectorOptions& options,
                     std::span<LinePiece> pieces, std::vector<Arc>& arcs) {
  options_ = &options;
  has_moments_ = false;
  contenders_.clear();
  const auto num_pieces = static_cast<int>(pieces.size());
  for (int i = 0; i < num_pieces; ++i) {
    for (int j = std::min(num_pieces, i + kMaxPiecesOfArc) - 1; j >= i; --j) {
      if (is_part_of_contender(i, j)) continue;
      Contender contender{i, j, {}};
      if (try_pieces(scan, surface, pieces, contender)) contenders_.push_back(contender);
    }
  }
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

// What one arc explains as well as can be asked is not looked at piece by piece.
bool ArcFinder::is_part_of_contender(int first_piece, int last_piece) const {
  return std::any_of(contenders_.begin(), contenders_.end(), [&](const Contender& c) {
    return c.first_piece <= first_piece && last_piece <= c.last_piece &&
           c.arc.fit.chi2 <= kGoodChi2PerEcho * c.arc.num_echoes();
  });
}

bool ArcFinder::try_pieces(const SurfacedScan& scan, Stretch surface, std::span<const LinePiece> pieces,
                           Contender& contender) {
  const Stretch places{pieces[contender.first_piece].places.first, pieces[contender.last_piece].places.last};
  if (places.size() < options_->circle.min_points) return false;
  double cost = 0.0;
  for (int i = contender.first_piece; i <= contender.last_piece; ++i) cost += pieces[i].cost;
  if (cost <= options_->surface.arc_price || !bulges(scan, places)) return false;
  if (!has_moments_) moments_.build(scan.echoes, scan.order, surface);
  has_moments_ = true;
  if (options_->surface.arc_price + moments_.chi2(places) / kAlgebraicExcess > cost) return false;
  Arc& arc = contender.arc;
  arc.parts[0] = places;
  if (!fit_trimmed(scan, surface, arc) || !is_plausible(arc)) return false;
  const int num_dropped = places.size() - arc.num_echoes();
  arc.gain = cost - arc.fit.chi2 - arc.price - options_->surface.clutter_price * num_dropped;
  return arc.gain > 0.0;
}

std::optional<Arc> ArcFinder::join(const SurfacedScan& scan, Stretch before, Stretch after,
                                   const DetectorOptions& options, double cost) {
  options_ = &options;
  Arc arc{.parts = {before, after}, .num_parts = 2};
  const int num_echoes = arc.num_echoes();
  if (num_echoes < options.circle.min_points) return std::nullopt;
  if (!fit_trimmed(scan, {before.first, after.last}, arc) || !is_plausible(arc)) return std::nullopt;
  const int num_dropped = num_echoes - arc.num_echoes();
  arc.gain = cost - arc.fit.chi2 - arc.price - options.surface.clutter_price * num_dropped;
  if (arc.gain <= 0.0) return std::nullopt;
  return arc;
}

// Quick to see; what does not bulge towards the sensor is no arc.
bool ArcFinder::bulges(const SurfacedScan& scan, Stretch places) const {
  const auto point_m = [&](int place) { return scan.echoes.point_m(scan.order[place]); };
  const Eigen::Vector2d a_m = point_m(places.first);
  const Eigen::Vector2d chord_m = point_m(places.last) - a_m;
  const Eigen::Vector2d d_m = point_m((places.first + places.last) / 2) - a_m;
  const double side = chord_m.y() * a_m.x() - chord_m.x() * a_m.y();
  const double bulge_m2 = (chord_m.x() * d_m.y() - chord_m.y() * d_m.x()) * (side < 0.0 ? -1.0 : 1.0);
  return bulge_m2 >= kMinBulgeRatio * chord_m.squaredNorm();
}

bool ArcFinder::is_plausible(const Arc& arc) const {
  const SurfaceOptions& o = options_->surface;
  return arc.fit.radius_m >= o.min_radius_m && arc.fit.radius_m <= o.max_radius_m &&
         arc.fit.chi2 <= o.max_chi2(arc.num_echoes());
}

bool ArcFinder::fit_trimmed(const SurfacedScan& scan, Stretch surface, Arc& arc) {
  const int num_echoes = arc.num_echoes();
  for (int round = 0; round < kMaxTrimRounds; ++round) {
    if (!fit_between_ends(scan, surface, arc)) return false;
    if (round + 1 == kMaxTrimRounds || !drop_mixed_ends(scan, arc)) break;
    if (num_echoes - arc.num_echoes() > kMaxTrimmed * arc.num_parts) return false;
  }
  return true;
}

bool ArcFinder::fit_between_ends(const SurfacedScan& scan, Stretch surface, Arc& arc) {
  const SurfaceOptions& o = options_->surface;
  const ArcEnd ends[2] = {arc_end_at(scan.scan, scan.echoes, scan.order, surface, arc.parts[0].first, -1),
                          arc_end_at(scan.scan, scan.echoes, scan.order, surface, arc.last_part().last, 1)};
  Witness witnesses[2];
  std::size_t num_witnesses = 0;
  arc.price = o.arc_price;
  for (const ArcEnd& end : ends) {
    if (end.kind == ArcEndKind::kFree) witnesses[num_witnesses++] = end.witness;
    if (end.kind == ArcEndKind::kHidden) arc.price += o.hidden_end_price;
    if (end.kind == ArcEndKind::kAttached) arc.price += o.attached_end_price;
  }
  members_.clear();
  for (int part = 0; part < arc.num_parts; ++part) {
    for (int i = arc.parts[part].first; i <= arc.parts[part].last; ++i) members_.push_back(scan.order[i]);
  }
  const auto fit = fit_arc(scan.echoes, members_, {witnesses, num_witnesses});
  if (!fit) return false;
  arc.fit = *fit;
  const bool is_free = num_witnesses == 2;
  arc.doubt = is_free ? 0.0 : o.unsure_arc_price;
  if (!is_free && arc_in_view_rad(scan, arc) < o.shallow_arc_rad) arc.doubt += o.shallow_arc_price;
  arc.doubt = std::max(arc.doubt,
                       std::min(o.doubt_ratio * (expected_gain(scan, arc, o) - o.doubt_start), o.max_doubt));
  return true;
}

bool ArcFinder::drop_mixed_ends(const SurfacedScan& scan, Arc& arc) const {
  const auto is_off = [&](int place) {
    return std::abs(arc.fit.residual(scan.echoes, scan.order[place])) > kTrimResidual;
  };
  const int before = arc.num_echoes();
  const int least = arc.num_parts == 1 ? options_->circle.min_points : kMinPartEchoes;
  for (int part = 0; part < arc.num_parts; ++part) {
    Stretch& places = arc.parts[part];
    while (places.size() > least && is_off(places.first)) ++places.first;
    while (places.size() > least && is_off(places.last)) --places.last;
  }
  return arc.num_echoes() < before;
}

}  // namespace scanbed
