// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <vector>

namespace scanbed::bench {

/// Labelled places by scan number, sensor frame.
using Labels = std::map<int, std::vector<Eigen::Vector2d>>;

/// A labelled leg is found where one lies within this.
inline constexpr double kLegGate_m = 0.15;

/// One arc a line: {"scan": n, "cx": x, "cy": y, ...}. @throws std::runtime_error with file and line where it
/// is not.
Labels read_circle_labels(const std::filesystem::path& path);

/// One scan a line: {"scan": n, "legs": [{"x": x, "y": y, "n": points}, ...]}; legs of fewer than
/// min_points points are left out.
Labels read_leg_labels(const std::filesystem::path& path, int min_points = 3);

}  // namespace scanbed::bench
