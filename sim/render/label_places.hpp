// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace scanbed::sim {

/// A text that belongs to a place of a picture. Pixels count right and down.
struct Label {
  Eigen::Vector2d anchor_px;  ///< what it names
  Eigen::Vector2d size_px;
};

/// Where labels go: above what they name; where others stand, or the picture ends, below it, beside it or
/// farther away. One after the other, each to the place where it covers least of the earlier labels and of
/// all anchors, as near as that allows.
///
/// @return a box for each label, in their order.
std::vector<Eigen::AlignedBox2d> label_places(std::span<const Label> labels,
                                              const Eigen::AlignedBox2d& picture_px);

}  // namespace scanbed::sim
