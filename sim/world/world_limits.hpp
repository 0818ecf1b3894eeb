// SPDX-License-Identifier: MIT
#pragma once

namespace scanbed::sim {

/// Farther from the origin than this nothing is put, and no length is greater: the planar engine counts in
/// single precision, and within a kilometre its steps stay below 0.1 mm.
inline constexpr double kFarthest_m = 1000.0;

/// Edges of outlines and paths are at least this long.
inline constexpr double kMinEdge_m = 1e-3;

}  // namespace scanbed::sim
