// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/detect/features.hpp"
#include "core/scan/laser_scan.hpp"
#include "core/scan/truth.hpp"
#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

/// 8-bit RGB, rows from the top.
struct Image {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 * width_px * height_px
};

enum class View {
  kTop,
  kCamera,
  kLaser
};  ///< plan from above, oblique over the whole scene, from the laser along its x axis

/// Lines to measure by: on the floor along the world's axes, or about the laser.
enum class Grid { kNone, kCartesian, kPolar };

struct PictureOptions {
  static constexpr int kLeast_px = 64;   ///< of width and height
  static constexpr int kMost_px = 4096;  ///< of width and height

  int width_px = 960;
  int height_px = 720;
  View view = View::kCamera;
  Grid grid = Grid::kNone;  ///< a plan has its Cartesian lines unless kPolar is asked for
  bool beams = true;        ///< not in the laser's own view, where they would only be a mess
  bool features = true;
  bool truth = false;     ///< outlines of the objects that the scan truly met
  bool labels = false;    ///< ids of those objects
  void validate() const;  ///< @throws InputError naming the first field out of range
};

/// What a laser saw, and what was found in it.
struct Sight {
  const LaserScan& scan;         ///< in the sensor frame, state.X_WR * robot.X_RS of the state painted
  const Features& features;      ///< likewise
  const Truth* truth = nullptr;  ///< of the scan; without it truth and labels are not drawn
};

/// Off-screen pictures of a world (MuJoCo drawn by OSMesa) with a scan and its features drawn over it: lines
/// red, circles green, legs purple, as in the paper.
class ScenePainter {
 public:
  /// Builds the three-dimensional scene once. @throws InputError, SensorFault (kSimulator) where MuJoCo
  /// refuses it.
  ScenePainter(const World& world, const PictureOptions& options);
  ~ScenePainter();
  ScenePainter(const ScenePainter&) = delete;
  ScenePainter& operator=(const ScenePainter&) = delete;

  /// @param caption  one line at the top of the picture.
  Image paint(const WorldState& state, const Sight& sight, const std::string& caption);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The bytes of a PNG file.
std::string png_of(const Image& image);

}  // namespace scanbed::sim
