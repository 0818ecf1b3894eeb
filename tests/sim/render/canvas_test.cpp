// SPDX-License-Identifier: MIT
#include "sim/render/canvas.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "tests/support/pixels.hpp"

namespace scanbed::sim {
namespace {

Image plain(int width_px, int height_px, std::uint8_t level) {
  return {width_px, height_px,
          std::vector<std::uint8_t>(static_cast<std::size_t>(3) * width_px * height_px, level)};
}

const Rgba kRed{1.0, 0.0, 0.0, 1.0};

bool is_dark(const Eigen::Vector3d& color) {
  return color.maxCoeff() < 0.5;
}

TEST(CanvasTest, KeepsTheBackgroundToTheBit) {
  Image background = plain(37, 11, 0);
  for (std::size_t i = 0; i < background.rgb.size(); ++i)
    background.rgb[i] = static_cast<std::uint8_t>(i * 7);
  EXPECT_EQ(Canvas(background).image().rgb, background.rgb);
}

TEST(CanvasTest, StrokesAreAsWideAsAskedFor) {
  Canvas canvas(plain(40, 40, 255));
  canvas.stroke({{{5.0, 20.0}, {35.0, 20.0}}}, {kRed, 4.0});
  const Image image = canvas.image();
  for (const double row_px : {18.5, 19.5, 20.5, 21.5}) {
    EXPECT_EQ(pixel(image, {20.0, row_px}), Eigen::Vector3d(1, 0, 0)) << row_px;
  }
  for (const double row_px : {17.5, 22.5}) EXPECT_EQ(pixel(image, {20.0, row_px}), Eigen::Vector3d(1, 1, 1));
}

TEST(CanvasTest, EndsAreRoundOnlyWhereAskedFor) {
  const auto beyond_the_end = [](bool round_ends) {
    Canvas canvas(plain(40, 40, 255));
    canvas.stroke({{{5.0, 20.0}, {30.0, 20.0}}}, {kRed, 6.0, round_ends});
    return pixel(canvas.image(), {31.5, 20.0});
  };
  EXPECT_EQ(beyond_the_end(true), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(beyond_the_end(false), Eigen::Vector3d(1, 1, 1));
}

TEST(CanvasTest, TranslucentLinesOfOneStrokeDoNotAddUp) {
  Canvas canvas(plain(40, 40, 255));
  canvas.stroke({{{0.0, 20.0}, {40.0, 20.0}}, {{20.0, 0.0}, {20.0, 40.0}}}, {{0, 0, 0, 0.5}, 6.0});
  EXPECT_NEAR(pixel(canvas.image(), {20.0, 20.0}).x(), pixel(canvas.image(), {5.0, 20.0}).x(), 1.5 / 255.0);
}

TEST(CanvasTest, DotsAndFillsCoverTheirInside) {
  Canvas canvas(plain(40, 40, 255));
  canvas.dots({{10.0, 10.0}}, 4.0, kRed);
  canvas.fill({{20, 20}, {30, 20}, {30, 30}, {20, 30}}, kRed);
  const Image image = canvas.image();
  EXPECT_TRUE(is_red(pixel(image, {10.0, 10.0})));
  EXPECT_TRUE(is_red(pixel(image, {25.0, 25.0})));
  EXPECT_FALSE(is_red(pixel(image, {15.0, 10.0})));
  EXPECT_FALSE(is_red(pixel(image, {25.0, 31.5})));
}

TEST(CanvasTest, ShortLinesAndPointsOutsideAreNoTrouble) {
  Canvas canvas(plain(40, 40, 255));
  canvas.stroke({{}, {{3.0, 3.0}}}, {kRed, 4.0});
  canvas.stroke({{{-1e5, 20.0}, {1e5, 20.0}}}, {kRed, 4.0});
  canvas.dots({{-50.0, -50.0}}, 4.0, kRed);
  canvas.fill({}, kRed);
  EXPECT_TRUE(is_red(pixel(canvas.image(), {20.0, 20.0})));
  EXPECT_FALSE(is_red(pixel(canvas.image(), {3.0, 3.0})));
}

TEST(CanvasTest, TextIsAsWideAsItSays) {
  const TextStyle style{{0, 0, 0, 1}, 20.0};
  Canvas canvas(plain(300, 60, 255));
  const double width_px = canvas.text_width_px("scan 42", style);
  EXPECT_GT(width_px, 40.0);
  canvas.text({10.0, 40.0}, "scan 42", style);
  const Image image = canvas.image();
  int last_dark = 0;
  for (int column = 0; column < 300; ++column) {
    for (int row = 0; row < 60; ++row) {
      if (is_dark(pixel(image, {column + 0.5, row + 0.5}))) last_dark = column;
    }
  }
  EXPECT_NEAR(last_dark, 10.0 + width_px, 3.0);
}

TEST(CanvasTest, TextOfAnyBytesIsDrawnAndDrawingGoesOn) {
  Canvas canvas(plain(300, 60, 255));
  for (const std::string text :
       {"\xff\xfe", "cut \xe2\x82", "\xc0\x80", "\xed\xa0\x80", "tab\tline\n", "Säule 柱", ""}) {
    canvas.text({10.0, 40.0}, text, {});
  }
  EXPECT_GT(count_pixels(canvas.image(), 0, 60, is_dark), 20);
  canvas.dots({{200.0, 30.0}}, 4.0, kRed);
  EXPECT_TRUE(is_red(pixel(canvas.image(), {200.0, 30.0})));
}

}  // namespace
}  // namespace scanbed::sim
