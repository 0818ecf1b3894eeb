// SPDX-License-Identifier: MIT
#include "sim/render/scene_renderer.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/errors/ensure.hpp"
#include "core/errors/sensor_fault.hpp"
#include "sim/render/gl_context.hpp"
#include "sim/spatial/appearance.hpp"

namespace scanbed::sim {
namespace {

void copy(const Eigen::Vector3d& from, float* to) {
  for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(from[i]);
}

mjvGLCamera gl_camera(const ViewCamera& camera) {
  mjvGLCamera gl{};
  copy(camera.X_WC.translation(), gl.pos);
  copy(-camera.X_WC.linear().col(2), gl.forward);
  copy(camera.X_WC.linear().col(1), gl.up);
  const double half_m = camera.near_m * camera.half_height_ratio;
  gl.frustum_bottom = static_cast<float>(-half_m);
  gl.frustum_top = static_cast<float>(half_m);
  gl.frustum_near = static_cast<float>(camera.near_m);
  gl.frustum_far = static_cast<float>(camera.far_m);
  return gl;
}

// MuJoCo clips a directional lamp's shadows at the camera's near and far plane, counted from the lamp: the
// lamp goes to where the scene lies halfway between them.
void place_lamps(const ViewCamera& camera, const mjModel& model, mjvScene& scene) {
  const double distance_m = 0.5 * (camera.near_m + camera.far_m);
  for (int i = 0; i < scene.nlight; ++i) {
    mjvLight& light = scene.lights[i];
    if (!light.directional || light.headlight) continue;
    for (int k = 0; k < 3; ++k) {
      light.pos[k] = static_cast<float>(model.stat.center[k] - distance_m * light.dir[k]);
    }
  }
}

/// A picture as OpenGL left it.
struct Pixels {
  std::size_t width_px;
  std::vector<std::uint8_t> rgb;
  std::vector<float> depth;

  bool is_black(std::size_t i) const { return rgb[3 * i] + rgb[3 * i + 1] + rgb[3 * i + 2] == 0; }
};

// Beyond the floor a plan shows what OpenGL left black, for the sky is farther than its far plane. Pixels
// that touch it hold some of that black.
std::vector<bool> find_nothing(const Pixels& pixels) {
  const std::size_t num_pixels = pixels.depth.size();
  std::vector<bool> is_nothing(num_pixels);
  for (std::size_t i = 0; i < num_pixels; ++i) {
    if (pixels.depth[i] < 1.0F) continue;
    is_nothing[i] = true;
    if (!pixels.is_black(i)) continue;
    const std::size_t column = i % pixels.width_px;
    if (column > 0) is_nothing[i - 1] = true;
    if (column + 1 < pixels.width_px) is_nothing[i + 1] = true;
    if (i >= pixels.width_px) is_nothing[i - pixels.width_px] = true;
    if (i + pixels.width_px < num_pixels) is_nothing[i + pixels.width_px] = true;
  }
  return is_nothing;
}

void paint_nothing(Pixels& pixels) {
  static const Eigen::Array<std::uint8_t, 3, 1> sky =
      (255.0 * kSkyColor).array().round().cast<std::uint8_t>();
  const std::vector<bool> is_nothing = find_nothing(pixels);
  for (std::size_t i = 0; i < is_nothing.size(); ++i) {
    if (is_nothing[i]) std::copy(sky.begin(), sky.end(), pixels.rgb.data() + 3 * i);
  }
}

}  // namespace

struct SceneRenderer::Impl {
  Impl(mjModel& mj_model, PictureSize picture_size) : model(mj_model), size(picture_size) {
    model.vis.global.offwidth = size.width_px;
    model.vis.global.offheight = size.height_px;
    mjv_defaultOption(&option);
    mjv_defaultFreeCamera(&model, &free_camera);
    mjv_defaultScene(&scene);
    mjr_defaultContext(&context);
    // A slack rope hangs in a curve of many pieces.
    constexpr int kPiecesPerRope = 128;
    mjv_makeScene(&model, &scene, model.ngeom + model.ntendon * kPiecesPerRope + 64);
    scene.flags[mjRND_SHADOW] = 1;
    scene.flags[mjRND_REFLECTION] = 0;
    scene.flags[mjRND_HAZE] = 0;
    gl.make_current();
    mjr_makeContext(&model, &context, mjFONTSCALE_50);
    mjr_setBuffer(mjFB_OFFSCREEN, &context);
  }
  ~Impl() {
    gl.make_current();
    mjr_freeContext(&context);
    mjv_freeScene(&scene);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  mjModel& model;
  PictureSize size;
  GlContext gl;
  mjvOption option{};
  mjvCamera free_camera{};
  mjvScene scene{};
  mjrContext context{};
};

SceneRenderer::SceneRenderer(mjModel& model, PictureSize size) : impl_(std::make_unique<Impl>(model, size)) {
  if (impl_->context.currentBuffer != mjFB_OFFSCREEN) {
    throw SensorFault(SensorFault::Kind::kSimulator, "off-screen OpenGL: no framebuffer of this size");
  }
}

SceneRenderer::~SceneRenderer() = default;

void SceneRenderer::cast_shadows(bool on) {
  impl_->scene.flags[mjRND_SHADOW] = on ? 1 : 0;
}

RenderedScene SceneRenderer::render(mjData& data, const ViewCamera& camera) {
  Impl& self = *impl_;
  const int width_px = self.size.width_px;
  const int height_px = self.size.height_px;
  SCANBED_ENSURE(camera.width_px == width_px && camera.height_px == height_px);

  self.gl.make_current();
  mjv_updateScene(&self.model, &data, &self.option, nullptr, &self.free_camera, mjCAT_ALL, &self.scene);
  self.scene.camera[0] = gl_camera(camera);
  self.scene.camera[1] = self.scene.camera[0];
  place_lamps(camera, self.model, self.scene);
  const mjrRect viewport{0, 0, width_px, height_px};
  mjr_render(viewport, &self.scene, &self.context);

  const std::size_t num_pixels = static_cast<std::size_t>(width_px) * height_px;
  Pixels pixels{static_cast<std::size_t>(width_px), std::vector<std::uint8_t>(3 * num_pixels),
                std::vector<float>(num_pixels)};
  mjr_readPixels(pixels.rgb.data(), pixels.depth.data(), viewport, &self.context);
  paint_nothing(pixels);

  // OpenGL counts rows from below, and its depth is hyperbolic between the near and the far plane.
  RenderedScene result{{width_px, height_px, std::vector<std::uint8_t>(3 * num_pixels)},
                       std::vector<float>(num_pixels)};
  const auto near_m = static_cast<float>(camera.near_m);
  const auto far_m = static_cast<float>(camera.far_m);
  for (int row = 0; row < height_px; ++row) {
    const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(height_px - 1 - row) * width_px;
    const std::ptrdiff_t to = static_cast<std::ptrdiff_t>(row) * width_px;
    std::copy_n(pixels.rgb.begin() + 3 * from, 3 * width_px, result.image.rgb.begin() + 3 * to);
    std::transform(pixels.depth.begin() + from, pixels.depth.begin() + from + width_px,
                   result.depth_m.begin() + to,
                   [=](float d) { return near_m * far_m / (far_m - d * (far_m - near_m)); });
  }
  return result;
}

}  // namespace scanbed::sim
