// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "sim/render/scene_picture.hpp"

namespace scanbed::sim {

/// Colour of a stroke, a dot or a text: red, green, blue, opacity in [0, 1].
using Rgba = Eigen::Vector4d;

struct Stroke {
  Rgba color{0.0, 0.0, 0.0, 1.0};
  double width_px = 1.0;
  bool round_ends = true;  ///< false where strokes are laid end to end
};

struct TextStyle {
  Rgba color{0.1, 0.1, 0.12, 1.0};
  double size_px = 14.0;
  bool bold = false;
};

/// Two-dimensional, anti-aliased drawing over a picture. Pixels count right and down from the upper left
/// corner; what falls outside is cut off.
class Canvas {
 public:
  using Polyline = std::vector<Eigen::Vector2d>;

  explicit Canvas(const Image& background);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }

  /// Draws all polylines as one: where they cross, a translucent colour does not add up. Those of less than
  /// two points are left out.
  void stroke(const std::vector<Polyline>& lines, const Stroke& style);
  void fill(const Polyline& outline, const Rgba& color);
  void dots(const Polyline& centers, double radius_px, const Rgba& color);

  /// Baseline starts at `at_px`. Bytes that are no UTF-8, and control characters, are shown as '?'.
  void text(const Eigen::Vector2d& at_px, const std::string& text, const TextStyle& style);
  /// Advance of a text.
  double text_width_px(const std::string& text, const TextStyle& style);

  Image image() const;

 private:
  struct Impl;
  int width_px_;
  int height_px_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scanbed::sim
