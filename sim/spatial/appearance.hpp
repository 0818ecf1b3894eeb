// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string_view>

#include "sim/world/world.hpp"

namespace scanbed::sim {

/// Red, green, blue in [0, 1]. The colours of things are muted: red, green and purple belong to what the
/// detectors find.
using Rgb = Eigen::Vector3d;

/// By label and shape; grey for a label that has no colour of its own.
Rgb solid_color(const Solid& solid);

struct WalkerColors {
  Rgb shirt;
  Rgb trousers;
};

/// By index in World::walkers; neighbours differ.
WalkerColors walker_colors(int walker);

inline const Rgb kSkyColor{0.93, 0.945, 0.96};
inline const Rgb kSkinColor{0.87, 0.70, 0.58};
inline const Rgb kShoeColor{0.17, 0.16, 0.16};
inline const Rgb kTowColor{0.42, 0.56, 0.70};
inline const Rgb kRopeColor{0.36, 0.27, 0.18};
inline const Rgb kRobotColor{0.07, 0.07, 0.08};
inline const Rgb kLaserColor{0.10, 0.32, 0.85};

}  // namespace scanbed::sim
