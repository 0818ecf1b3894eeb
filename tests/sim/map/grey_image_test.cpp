// SPDX-License-Identifier: MIT
#include "sim/map/grey_image.hpp"

#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/errors/input_error.hpp"

namespace scanbed::sim {
namespace {

using Shades = std::vector<std::uint8_t>;

std::string error_of(const std::string& bytes, const ImageLimits& limits = {}) {
  try {
    decode_grey_image(bytes, "m.pgm", limits);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string png_of(png_uint_32 format, png_uint_32 width, png_uint_32 height, const void* pixels) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = width;
  png.height = height;
  png.format = format;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(png) + 1000, '\0');
  png_alloc_size_t size = bytes.size();
  EXPECT_NE(png_image_write_to_memory(&png, bytes.data(), &size, 0, pixels, 0, nullptr), 0);
  bytes.resize(size);
  return bytes;
}

TEST(GreyImageTest, ReadsPgmAsText) {
  const GreyImage image = decode_grey_image("P2\n# a map\n3 2 # wide, high\n10\n0 5 10\n10 0 1\n", "m");
  EXPECT_EQ(image.width_px, 3);
  EXPECT_EQ(image.height_px, 2);
  EXPECT_EQ(image.shades, (Shades{0, 128, 255, 255, 0, 26}));
  EXPECT_TRUE(image.is_clear.empty());
}

TEST(GreyImageTest, ReadsRawPgmOfEightAndSixteenBits) {
  EXPECT_EQ(decode_grey_image(std::string("P5 2 1 255\n\0\xcd", 13), "m").shades, (Shades{0, 205}));
  EXPECT_EQ(decode_grey_image(std::string("P5 2 1 65535\n\xff\xff\x80\0", 17), "m").shades,
            (Shades{255, 128}));
  // A pixel that looks like a blank or a comment is a pixel.
  EXPECT_EQ(decode_grey_image(std::string("P5\n2 1\n255\n#\n"), "m").shades, (Shades{35, 10}));
}

TEST(GreyImageTest, ReadsPngInGreyColourAndWithAlpha) {
  const Shades grey = {0, 100, 205, 254};
  EXPECT_EQ(decode_grey_image(png_of(PNG_FORMAT_GRAY, 2, 2, grey.data()), "m").shades, grey);
  const Shades rgb = {255, 0, 0, 10, 20, 30};
  EXPECT_EQ(decode_grey_image(png_of(PNG_FORMAT_RGB, 2, 1, rgb.data()), "m").shades, (Shades{85, 20}));
  const Shades with_alpha = {0, 255, 0, 0};
  const GreyImage image = decode_grey_image(png_of(PNG_FORMAT_GA, 2, 1, with_alpha.data()), "m");
  EXPECT_EQ(image.is_clear, (std::vector<bool>{false, true}));
}

TEST(GreyImageTest, TellsWhereAPgmIsDamaged) {
  EXPECT_EQ(error_of(""), "m.pgm: byte 0: no image that can be read; expected PGM (P2, P5) or PNG");
  EXPECT_EQ(error_of("P6 1 1 255\nabc"),
            "m.pgm: byte 0: no image that can be read; expected PGM (P2, P5) or PNG");
  EXPECT_EQ(error_of("P2 x"), "m.pgm: byte 3: expected a number of [1, 1000000]");
  EXPECT_EQ(error_of("P2 1 1 70000 0"), "m.pgm: byte 7: expected a number of [1, 65535]");
  EXPECT_EQ(error_of("P2 1 2 9 5 10"), "m.pgm: byte 11: expected a number of [0, 9]");
  EXPECT_EQ(error_of("P2 1 2 9 5"), "m.pgm: byte 10: the file is cut off");
  EXPECT_EQ(error_of("P2 # only a comment"), "m.pgm: byte 19: the file is cut off");
  EXPECT_EQ(error_of("P5 9 9 255\nabc"), "m.pgm: byte 14: the file is cut off; expected 81 pixels");
  EXPECT_EQ(error_of("P5 2 3 65535\nabcdefg"), "m.pgm: byte 20: the file is cut off; expected 6 pixels");
}

TEST(GreyImageTest, TellsThatAPngIsDamaged) {
  const Shades grey(64 * 64, 7);
  const std::string png = png_of(PNG_FORMAT_GRAY, 64, 64, grey.data());
  EXPECT_EQ(error_of(png.substr(0, 20)).substr(0, 27), "m.pgm: not a readable PNG: ");
  EXPECT_EQ(error_of(png.substr(0, png.size() - 20)).substr(0, 27), "m.pgm: not a readable PNG: ");
  std::string flipped = png;
  flipped[png.size() / 2] = static_cast<char>(flipped[png.size() / 2] ^ 0x10);
  EXPECT_NE(error_of(flipped), "no error");
}

TEST(GreyImageTest, RefusesLargeImagesBeforeItTakesTheirMemory) {
  EXPECT_EQ(error_of("P5 900000 900000 255\n"),
            "m.pgm: the image is too large: 900000 x 900000 pixels; allowed: 16777216 in all");
  EXPECT_EQ(error_of("P5 2 3 255\nabcdef", {.max_pixels = 5}),
            "m.pgm: the image is too large: 2 x 3 pixels; allowed: 5 in all");
  EXPECT_EQ(error_of("P5 2 3 255\nabcdef", {.max_bytes = 16}), "m.pgm: file is too large; allowed: 0 KiB");
  const Shades grey(100, 7);
  EXPECT_EQ(error_of(png_of(PNG_FORMAT_GRAY, 10, 10, grey.data()), {.max_pixels = 99}),
            "m.pgm: the image is too large: 10 x 10 pixels; allowed: 99 in all");
}

TEST(GreyImageTest, ReadsFiles) {
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) /
                                     ("grey_image_test_" + std::to_string(::getpid()) + ".pgm");
  std::ofstream(path, std::ios::binary) << "P2 1 1 255 9";
  EXPECT_EQ(read_grey_image(path).shades, Shades{9});
  EXPECT_THROW(read_grey_image(path, {.max_bytes = 11}), InputError);
  std::filesystem::remove(path);
  EXPECT_THROW(read_grey_image(path), InputError);
}

}  // namespace
}  // namespace scanbed::sim
