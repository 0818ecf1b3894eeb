// SPDX-License-Identifier: MIT
#include "sim/render/scan_overlay.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sim/render/feature_colors.hpp"

namespace scanbed::sim {
namespace {

using Points = std::vector<Eigen::Vector3d>;

class FeaturePen {
 public:
  FeaturePen(ScenePen& pen, const Eigen::Isometry3d& X_WS, const OverlayStyle& style)
      : pen_(pen), X_WS_(X_WS), style_(style) {}

  void line(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m, const Rgba& color) const {
    if (from_m.allFinite() && to_m.allFinite()) outline({from_m, to_m}, color);
  }

  void ring(const Eigen::Vector2d& center_m, double radius_m, const Rgba& color) const {
    constexpr int kNumEdges = 48;
    if (!center_m.allFinite() || !std::isfinite(radius_m)) return;
    std::vector<Eigen::Vector2d> p_SQ;
    for (int i = 0; i <= kNumEdges; ++i) {
      const double angle_rad = 2.0 * kPi * i / kNumEdges;
      p_SQ.emplace_back(center_m + radius_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad)));
    }
    outline(p_SQ, color);
  }

  void dot(const Eigen::Vector2d& center_m, const Rgba& color) const {
    if (!center_m.allFinite()) return;
    pen_.dots({at(center_m, 0.0)}, 4.2 * style_.scale, kHalo);
    pen_.dots({at(center_m, 0.0)}, 2.9 * style_.scale, color);
  }

 private:
  inline static const Rgba kHalo{1.0, 1.0, 1.0, 0.75};

  Eigen::Vector3d at(const Eigen::Vector2d& p_SQ, double up_m) const {
    return X_WS_ * Eigen::Vector3d(p_SQ.x(), p_SQ.y(), up_m);
  }

  // A white edge keeps the colours apart from whatever they lie on.
  void outline(const std::vector<Eigen::Vector2d>& p_SQ, const Rgba& color) const {
    std::vector<double> heights_m{0.0};
    if (style_.ribbon_m > 0.0) heights_m = {-style_.ribbon_m, style_.ribbon_m};
    for (const bool halo : {true, false}) {
      for (const double up_m : heights_m) {
        Points p_WQ;
        for (const Eigen::Vector2d& p : p_SQ) p_WQ.push_back(at(p, up_m));
        pen_.stroke(p_WQ, {halo ? kHalo : color, (halo ? 6.5 : 3.6) * style_.scale});
      }
    }
  }

  ScenePen& pen_;
  const Eigen::Isometry3d& X_WS_;
  const OverlayStyle& style_;
};

struct Beam {
  Eigen::Vector3d u_W;
  double range_m;
};

// Near the laser the beams lie so close together that they would flow into a blot: ring by ring they get
// fainter towards it.
void draw_beams(ScenePen& pen, const Eigen::Vector3d& p_WS, const std::vector<Beam>& beams, double width_px) {
  constexpr std::array<double, 11> kRings_m{0.1, 0.25, 0.45, 0.7, 1.0, 1.4, 1.9, 2.5, 3.3, 4.5, 1e6};
  constexpr double kFullInk_m = 4.0;
  for (std::size_t ring = 0; ring + 1 < kRings_m.size(); ++ring) {
    std::vector<ScenePen::Polyline3> pieces;
    for (const Beam& beam : beams) {
      const double end_m = std::min(beam.range_m, kRings_m[ring + 1]);
      if (end_m > kRings_m[ring])
        pieces.push_back({p_WS + kRings_m[ring] * beam.u_W, p_WS + end_m * beam.u_W});
    }
    Rgba color = kBeamColor;
    color[3] *= std::min(1.0, kRings_m[ring + 1] / kFullInk_m);
    pen.stroke_all(pieces, {color, width_px, false});
  }
}

}  // namespace

void draw_scan(ScenePen& pen, const Eigen::Isometry3d& X_WS, const LaserScan& scan,
               const OverlayStyle& style) {
  std::vector<Beam> beams;
  Points echoes_W;
  for (int beam = 0; beam < scan.num_beams(); ++beam) {
    if (!scan.has_echo(beam)) continue;
    const double bearing_rad = scan.geometry.bearing_rad(beam);
    const Eigen::Vector3d u_S(std::cos(bearing_rad), std::sin(bearing_rad), 0.0);
    beams.push_back({X_WS.linear() * u_S, scan.range_m[beam]});
    echoes_W.emplace_back(X_WS.translation() + scan.range_m[beam] * beams.back().u_W);
  }
  if (style.beams) draw_beams(pen, X_WS.translation(), beams, std::max(0.7, 0.9 * style.scale));
  pen.dots(echoes_W, 1.7 * style.scale, kEchoColor);
}

void draw_features(ScenePen& pen, const Eigen::Isometry3d& X_WS, const Features& features,
                   const OverlayStyle& style) {
  constexpr double kLegRing_m = 0.11;
  const FeaturePen feature_pen(pen, X_WS, style);
  for (const Line& line : features.lines) feature_pen.line(line.left_m, line.right_m, kLineColor);
  for (const Circle& circle : features.circles) {
    feature_pen.ring(circle.center_m, circle.radius_m, kCircleColor);
    feature_pen.dot(circle.center_m, kCircleColor);
  }
  for (const Leg& leg : features.legs) {
    feature_pen.ring(leg.middle_m, kLegRing_m, kLegColor);
    feature_pen.dot(leg.middle_m, kLegColor);
  }
}

}  // namespace scanbed::sim
