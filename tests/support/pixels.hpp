// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>

#include "sim/render/scene_picture.hpp"

namespace scanbed::sim {

/// Colour in [0, 1] of the pixel that holds `at_px`; NaN outside the picture.
inline Eigen::Vector3d pixel(const Image& image, const Eigen::Vector2d& at_px) {
  const int column = static_cast<int>(std::floor(at_px.x()));
  const int row = static_cast<int>(std::floor(at_px.y()));
  if (column < 0 || row < 0 || column >= image.width_px || row >= image.height_px) {
    return Eigen::Vector3d::Constant(std::nan(""));
  }
  const std::size_t at = 3 * (static_cast<std::size_t>(row) * image.width_px + column);
  return Eigen::Vector3d(image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]) / 255.0;
}

inline bool is_red(const Eigen::Vector3d& c) {
  return c.x() > 0.7 && c.y() < 0.3 && c.z() < 0.3;
}
inline bool is_green(const Eigen::Vector3d& c) {
  return c.y() > 0.45 && c.x() < 0.25 && c.z() < 0.35;
}
inline bool is_purple(const Eigen::Vector3d& c) {
  return c.x() > 0.4 && c.z() > 0.55 && c.y() < 0.3;
}

/// Whether a pixel at most `reach_px` away is of that colour.
template <typename IsColor>
bool shows_near(const Image& image, const Eigen::Vector2d& at_px, double reach_px, IsColor is_color) {
  for (double dy = -reach_px; dy <= reach_px; ++dy) {
    for (double dx = -reach_px; dx <= reach_px; ++dx) {
      if (is_color(pixel(image, at_px + Eigen::Vector2d(dx, dy)))) return true;
    }
  }
  return false;
}

/// How many pixels are of that colour, in the rows [first_row, end_row).
template <typename IsColor>
int count_pixels(const Image& image, int first_row, int end_row, IsColor is_color) {
  int count = 0;
  for (int row = first_row; row < end_row; ++row) {
    for (int column = 0; column < image.width_px; ++column) {
      count += is_color(pixel(image, {column + 0.5, row + 0.5})) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace scanbed::sim
