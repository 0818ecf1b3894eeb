// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/detect/features.hpp"
#include "core/detect/leg/leg_beams.hpp"

namespace scanbed {

/// A circle that was found in a scan, as a leg's candidate sees it.
struct LegArc {
  float radius_m = 0.0F;
  int num_echoes = 0;  ///< that lie on it
};

/// The circles of a scan, those of too few echoes to be reported too, by the beams that met them.
class LegArcs {
 public:
  void mark(const LegBeams& beams, const Features& surfaces);
  /// The circle that a beam met, or null; valid until the next mark().
  const LegArc* at(int beam) const { return number_[beam] == kNone ? nullptr : &arcs_[number_[beam]]; }

 private:
  static constexpr int kNone = -1;

  void mark_circles(const LegBeams& beams, std::span<const Circle> circles);

  std::vector<LegArc> arcs_;
  std::vector<int> number_;  ///< of each beam: of its arc, or kNone
};

}  // namespace scanbed
