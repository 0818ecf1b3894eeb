// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <png.h>

#include <cstdint>
#include <string>
#include <utility>

#include "sim/render/scene_picture.hpp"

namespace scanbed::sim {
namespace {

Image gradient(int width_px, int height_px) {
  Image image{width_px, height_px, {}};
  for (int row = 0; row < height_px; ++row) {
    for (int column = 0; column < width_px; ++column) {
      image.rgb.push_back(static_cast<std::uint8_t>(3 * column));
      image.rgb.push_back(static_cast<std::uint8_t>(5 * row));
      image.rgb.push_back(static_cast<std::uint8_t>(column * row));
    }
  }
  return image;
}

Image read_png(const std::string& bytes) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size())) << png.message;
  png.format = PNG_FORMAT_RGB;
  Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  image.rgb.resize(PNG_IMAGE_SIZE(png));
  EXPECT_TRUE(png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr)) << png.message;
  return image;
}

TEST(PngOfTest, ReadsBackToTheSamePixels) {
  for (const auto& [width_px, height_px] : {std::pair{1, 1}, {97, 41}, {640, 480}}) {
    const Image image = gradient(width_px, height_px);
    const Image again = read_png(png_of(image));
    EXPECT_EQ(again.width_px, width_px);
    EXPECT_EQ(again.height_px, height_px);
    EXPECT_EQ(again.rgb, image.rgb);
  }
}

}  // namespace
}  // namespace scanbed::sim
