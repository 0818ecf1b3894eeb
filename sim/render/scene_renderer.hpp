// SPDX-License-Identifier: MIT
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <vector>

#include "sim/render/scene_picture.hpp"
#include "sim/render/view_camera.hpp"

namespace scanbed::sim {

/// A picture and how far away each of its pixels is.
struct RenderedScene {
  Image image;
  std::vector<float>
      depth_m;  ///< along the camera's axis, rows from the top; where nothing is, beyond everything
};

/// Draws MuJoCo's view of a model, off screen.
class SceneRenderer {
 public:
  /// @param model  changed: its off-screen buffer gets the size asked for. Must outlive the renderer.
  /// @throws SensorFault (kSimulator) where OpenGL fails.
  SceneRenderer(mjModel& model, PictureSize size);
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  /// @pre `camera` has the renderer's size. Checked; aborts.
  RenderedScene render(mjData& data, const ViewCamera& camera);

  /// On at first. A plan is clearer, and cheaper, without.
  void cast_shadows(bool on);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scanbed::sim
