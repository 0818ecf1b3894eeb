// SPDX-License-Identifier: MIT
#include "sim/render/scene_renderer.hpp"

#include <gtest/gtest.h>

#include "sim/spatial/appearance.hpp"
#include "sim/spatial/mjcf.hpp"
#include "sim/spatial/mujoco_model.hpp"
#include "sim/spatial/pose_actors.hpp"
#include "sim/spatial/world_bounds.hpp"
#include "tests/support/hall.hpp"
#include "tests/support/pixels.hpp"

namespace scanbed::sim {
namespace {

class SceneRendererTest : public ::testing::Test {
 protected:
  SceneRendererTest() { pose_actors(world_, test_hall_state(world_), *model_, *data_); }

  static float depth(const RenderedScene& scene, const Eigen::Vector2d& at_px) {
    return scene.depth_m[static_cast<std::size_t>(at_px.y()) * scene.image.width_px +
                         static_cast<std::size_t>(at_px.x())];
  }

  World world_ = test_hall();
  ModelPtr model_ = load_model(mjcf_of(world_));
  DataPtr data_ = make_data(*model_);
  PictureSize size_{400, 300};
  ViewCamera oblique_ = oblique_camera(world_bounds(world_), kPi / 2, size_, {});
};

TEST_F(SceneRendererTest, DepthIsTheDistanceAlongTheAxis) {
  SceneRenderer renderer(*model_, size_);
  const RenderedScene scene = renderer.render(*data_, oblique_);
  // Free floor, and the middle of the column's top: where they are in the picture, and how far, follows from
  // the pinhole.
  for (const Eigen::Vector3d& p_W : {Eigen::Vector3d(-4.5, 2.0, 0.0), {4.0, 4.5, 0.0}, {-2.0, 4.0, 2.5}}) {
    const auto at = oblique_.project(p_W);
    ASSERT_TRUE(at);
    // One pixel off is a few centimetres on a floor seen obliquely.
    EXPECT_NEAR(depth(scene, at->at_px), at->depth_m, 0.06) << p_W.transpose();
  }
}

TEST_F(SceneRendererTest, TheSkyIsBeyondEverything) {
  SceneRenderer renderer(*model_, size_);
  const RenderedScene scene = renderer.render(*data_, oblique_);
  for (int i = 0; i < 8; ++i) {
    const auto corner = static_cast<Eigen::AlignedBox3d::CornerType>(i);
    EXPECT_GT(depth(scene, {2.5, 2.5}), oblique_.project(world_bounds(world_).corner(corner))->depth_m + 2.0);
  }
}

TEST_F(SceneRendererTest, ThePlanHasTheRightHeights) {
  SceneRenderer renderer(*model_, size_);
  const ViewCamera plan = plan_camera(world_bounds(world_), size_, {});
  const RenderedScene scene = renderer.render(*data_, plan);
  const double height_m = plan.X_WC.translation().z();
  // 24 bits of depth over planes some 30 m apart, but floats of the camera's height: a few millimetres.
  EXPECT_NEAR(depth(scene, plan.project({2, 4, 2.5})->at_px), height_m - 2.5, 0.02);
  EXPECT_NEAR(depth(scene, plan.project({4, 7, 0.48})->at_px), height_m - 0.48, 0.02);
  EXPECT_NEAR(depth(scene, plan.project({-5, 5, 0})->at_px), height_m, 0.02);
}

TEST_F(SceneRendererTest, ShadowsFallInEveryViewAndCanBeSwitchedOff) {
  SceneRenderer renderer(*model_, size_);
  // The sun shines along the robot's heading, y: north of the column the floor is in its shadow. That is
  // hidden from the south, but not from the west.
  const ViewCamera west = oblique_camera(world_bounds(world_), 0.0, size_, {});
  const ViewCamera plan = plan_camera(world_bounds(world_), size_, {});
  for (const ViewCamera& camera : {west, plan}) {
    const Eigen::Vector2d shaded_px = camera.project({2.1, 4.6, 0.0})->at_px;
    renderer.cast_shadows(true);
    const double with = pixel(renderer.render(*data_, camera).image, shaded_px).sum();
    renderer.cast_shadows(false);
    const double without = pixel(renderer.render(*data_, camera).image, shaded_px).sum();
    EXPECT_LT(with, 0.85 * without);
  }
}

TEST_F(SceneRendererTest, TheSceneIsBright) {
  SceneRenderer renderer(*model_, size_);
  const RenderedScene scene = renderer.render(*data_, oblique_);
  const Eigen::Vector3d floor = pixel(scene.image, oblique_.project({-4.5, 2.0, 0.0})->at_px);
  EXPECT_GT(floor.minCoeff(), 0.75);
}

TEST_F(SceneRendererTest, BeyondTheFloorAPlanShowsTheSky) {
  const PictureSize wide{600, 200};
  SceneRenderer renderer(*model_, wide);
  const RenderedScene scene = renderer.render(*data_, plan_camera(world_bounds(world_), wide, {}));
  EXPECT_LT((pixel(scene.image, {2.5, 100.5}) - kSkyColor).cwiseAbs().maxCoeff(), 1.0 / 255.0);
}

// However the edges of the floor lie between the pixels: floor and sky are both bright.
TEST_F(SceneRendererTest, APlansFloorHasNoDarkEdge) {
  const ModelPtr model = load_model(mjcf_of(World{}));
  const DataPtr data = make_data(*model);
  pose_actors(World{}, {}, *model, *data);
  for (int width_px = 300; width_px < 304; ++width_px) {
    const PictureSize size{width_px, 100};
    SceneRenderer renderer(*model, size);
    const RenderedScene scene = renderer.render(*data, plan_camera(world_bounds(World{}), size, {}));
    // Beside the robot, which stands in the middle.
    for (int x_px = 0; x_px < width_px; ++x_px) {
      EXPECT_GT(pixel(scene.image, {x_px + 0.5, 20.5}).minCoeff(), 0.75) << x_px << " of " << width_px;
    }
  }
}

TEST_F(SceneRendererTest, SeveralRenderersTakeTurns) {
  SceneRenderer first(*model_, size_);
  const RenderedScene alone = first.render(*data_, oblique_);
  const ModelPtr other_model = load_model(mjcf_of(World{}));
  const DataPtr other_data = make_data(*other_model);
  {
    SceneRenderer second(*other_model, {64, 64});
    pose_actors(World{}, {}, *other_model, *other_data);
    second.render(*other_data, oblique_camera(world_bounds(World{}), 0.0, {64, 64}, {}));
    EXPECT_EQ(first.render(*data_, oblique_).image.rgb, alone.image.rgb);
  }
  EXPECT_EQ(first.render(*data_, oblique_).image.rgb, alone.image.rgb);
}

}  // namespace
}  // namespace scanbed::sim
