// SPDX-License-Identifier: MIT
#include "sim/render/picture_frame.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "sim/render/feature_colors.hpp"
#include "tests/support/pixels.hpp"

namespace scanbed::sim {
namespace {

Image grey(int width_px, int height_px) {
  return {width_px, height_px,
          std::vector<std::uint8_t>(static_cast<std::size_t>(3) * width_px * height_px, 150)};
}

bool is_ink(const Eigen::Vector3d& c) {
  return c.maxCoeff() < 0.3;
}

TEST(PictureFrameTest, StepsAreRound) {
  EXPECT_DOUBLE_EQ(round_step_m(1.0), 1.0);
  EXPECT_DOUBLE_EQ(round_step_m(1.1), 2.0);
  EXPECT_DOUBLE_EQ(round_step_m(2.5), 5.0);
  EXPECT_DOUBLE_EQ(round_step_m(7.0), 10.0);
  EXPECT_DOUBLE_EQ(round_step_m(0.03), 0.05);
  EXPECT_DOUBLE_EQ(round_step_m(430.0), 500.0);
}

TEST(PictureFrameTest, TheCaptionIsOneLineAtTheTop) {
  Canvas canvas(grey(960, 720));
  draw_caption(canvas, "static_hallway, t = 10 s");
  EXPECT_GT(count_pixels(canvas.image(), 0, 36, is_ink), 200);
  EXPECT_EQ(count_pixels(canvas.image(), 37, 720, is_ink), 0);
}

TEST(PictureFrameTest, AnEmptyCaptionTakesNoRoom) {
  Canvas canvas(grey(960, 720));
  draw_caption(canvas, "");
  EXPECT_EQ(canvas.image().rgb, grey(960, 720).rgb);
}

TEST(PictureFrameTest, ALongCaptionIsCutBeforeTheEdge) {
  for (const std::string& unit : {std::string("word "), std::string("柱")}) {
    std::string caption;
    for (int i = 0; i < 300; ++i) caption += unit;
    Canvas canvas(grey(320, 240));
    draw_caption(canvas, caption);
    const Image image = canvas.image();
    int in_margin = 0;
    for (int row = 0; row < 20; ++row) {
      for (int column = 315; column < 320; ++column) in_margin += is_ink(pixel(image, {column, row})) ? 1 : 0;
    }
    EXPECT_EQ(in_margin, 0);
    EXPECT_GT(count_pixels(image, 0, 22, is_ink), 0);
  }
}

TEST(PictureFrameTest, TheLegendShowsAllColours) {
  Canvas canvas(grey(960, 720));
  draw_legend(canvas, {}, "floor tiles: 1 m");
  const Image image = canvas.image();
  EXPECT_GT(count_pixels(image, 686, 720, is_red), 30);
  EXPECT_GT(count_pixels(image, 686, 720, is_green), 30);
  EXPECT_GT(count_pixels(image, 686, 720, is_purple), 30);
  EXPECT_EQ(count_pixels(image, 0, 685, is_ink), 0);
}

TEST(PictureFrameTest, ANoteWithoutRoomIsLeftOut) {
  const auto legend = [](const std::string& note) {
    Canvas canvas(grey(960, 720));
    draw_legend(canvas, {}, note);
    return canvas.image().rgb;
  };
  EXPECT_NE(legend("floor tiles: 1 m"), legend(""));
  EXPECT_EQ(legend(std::string(200, 'x')), legend(""));
}

TEST(PictureFrameTest, TheScaleBarIsTrue) {
  Canvas canvas(grey(960, 720));
  // 12 x 9 m in 960 x 720 pixels: 80 a metre. At least 60 pixels are asked for: the bar is 1 m.
  const ViewCamera camera =
      plan_camera({Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(12, 9, 1)}, {960, 720}, {0, 0, 0});
  draw_plan_scale(canvas, camera);
  const Image image = canvas.image();
  int length_px = 0;
  // The number stands to the left of it.
  for (int column = 852; column < 960; ++column)
    length_px += is_ink(pixel(image, {column + 0.5, 703.0})) ? 1 : 0;
  EXPECT_NEAR(length_px, 80, 3);
}

TEST(PictureFrameTest, GridLinesLieAtWholeMetres) {
  Canvas canvas(grey(960, 720));
  const ViewCamera camera =
      plan_camera({Eigen::Vector3d(-6, 0, 0), Eigen::Vector3d(6, 9, 1)}, {960, 720}, {0, 0, 0});
  draw_plan_scale(canvas, camera);
  const Image image = canvas.image();
  const auto darker = [](const Eigen::Vector3d& c) { return c.x() < 149.0 / 255.0; };
  // x = 2 m is 80 * (2 + 6) = 640 pixels from the left; y between two lines, away from the numbers.
  EXPECT_TRUE(shows_near(image, {640.0, 400.0 - 37.0}, 1.0, darker));
  EXPECT_FALSE(shows_near(image, {670.0, 400.0 - 37.0}, 1.0, darker));
}

}  // namespace
}  // namespace scanbed::sim
