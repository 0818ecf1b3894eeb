// SPDX-License-Identifier: MIT
#pragma once

#include "core/detect/robust/arc_fit.hpp"
#include "core/detect/robust/echoes.hpp"
#include "core/detect/robust/surface_runs.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// A scan with its echoes sorted by surface.
struct SurfacedScan {
  const LaserScan& scan;
  const Echoes& echoes;
};

/// What the beams beyond an end of an arc meet.
enum class ArcEndKind {
  kFree,      ///< the next beam passes by and sees farther
  kHidden,    ///< something nearer, or the edge of view, may hide the rest
  kAttached,  ///< the surface goes on
};

struct ArcEnd {
  ArcEndKind kind = ArcEndKind::kHidden;
  Witness witness;  ///< of a free end
};

/// Looks beyond the end of an arc; up to two beams there may have met both the arc and its background.
///
/// @param surface    on which the arc lies.
/// @param place      echo at the end.
/// @param direction  -1 towards lower beams, 1 towards higher ones.
ArcEnd arc_end_at(const SurfacedScan& scan, Stretch surface, int place, int direction);

}  // namespace scanbed
