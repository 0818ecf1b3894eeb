// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_arcs.hpp"

#include <cmath>

namespace scanbed {
namespace {

constexpr float kOnArc_m = 0.1F;

}  // namespace

void LegArcs::mark(const LegBeams& beams, const Features& surfaces) {
  arcs_.clear();
  number_.assign(beams.num_beams, kNone);
  mark_circles(beams, surfaces.circles);
  mark_circles(beams, surfaces.doubtful_circles);
}

// A circle whose middle something nearer hides has beams on both sides of that.
void LegArcs::mark_circles(const LegBeams& beams, std::span<const Circle> circles) {
  for (const Circle& circle : circles) {
    const Eigen::Vector2f center_m = circle.center_m.cast<float>();
    LegArc arc{.radius_m = static_cast<float>(circle.radius_m)};
    for (int beam = circle.beams.first; beam <= circle.beams.last; ++beam) {
      const float dx_m = beams.x_m[beam] - center_m.x();
      const float dy_m = beams.y_m[beam] - center_m.y();
      if (std::abs(std::sqrt(dx_m * dx_m + dy_m * dy_m) - arc.radius_m) > kOnArc_m) continue;
      number_[beam] = static_cast<int>(arcs_.size());
      ++arc.num_echoes;
    }
    arcs_.push_back(arc);
  }
}

}  // namespace scanbed
