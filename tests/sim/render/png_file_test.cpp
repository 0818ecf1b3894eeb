// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <png.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include "core/errors/input_error.hpp"
#include "sim/render/scene_picture.hpp"

namespace scanbed::sim {
namespace {

class PngFileTest : public ::testing::Test {
 protected:
  PngFileTest() {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = std::filesystem::temp_directory_path() / ("scanbed_png_" + name);
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~PngFileTest() override { std::filesystem::remove_all(folder_); }

  static Image gradient(int width_px, int height_px) {
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

  static Image read_png(const std::filesystem::path& path) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    EXPECT_TRUE(png_image_begin_read_from_file(&png, path.c_str())) << png.message;
    png.format = PNG_FORMAT_RGB;
    Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
    image.rgb.resize(PNG_IMAGE_SIZE(png));
    EXPECT_TRUE(png_image_finish_read(&png, nullptr, image.rgb.data(), 0, nullptr)) << png.message;
    return image;
  }

  std::ptrdiff_t num_files() const {
    return std::distance(std::filesystem::directory_iterator(folder_), std::filesystem::directory_iterator());
  }

  static std::string refusal(const std::filesystem::path& path) {
    try {
      write_png(gradient(8, 8), path);
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << path << " was written";
    return "";
  }

  std::filesystem::path folder_;
};

TEST_F(PngFileTest, ReadsBackToTheSamePixels) {
  for (const auto& [width_px, height_px] : {std::pair{1, 1}, {97, 41}, {640, 480}}) {
    const Image image = gradient(width_px, height_px);
    write_png(image, folder_ / "a.png");
    const Image again = read_png(folder_ / "a.png");
    EXPECT_EQ(again.width_px, width_px);
    EXPECT_EQ(again.height_px, height_px);
    EXPECT_EQ(again.rgb, image.rgb);
  }
  EXPECT_EQ(num_files(), 1);  // overwritten, and no temporary left
}

TEST_F(PngFileTest, AMissingDirectoryIsNamed) {
  const std::string message = refusal(folder_ / "none" / "a.png");
  EXPECT_NE(message.find((folder_ / "none" / "a.png").string()), std::string::npos) << message;
  EXPECT_NE(message.find("No such file or directory"), std::string::npos) << message;
  EXPECT_EQ(num_files(), 0);
}

TEST_F(PngFileTest, ADirectoryInItsPlaceIsRefusedAndNothingIsLeft) {
  std::filesystem::create_directory(folder_ / "a.png");
  refusal(folder_ / "a.png");
  EXPECT_EQ(num_files(), 1);
  EXPECT_TRUE(std::filesystem::is_directory(folder_ / "a.png"));
}

TEST_F(PngFileTest, AFileWhereADirectoryIsNeededIsRefused) {
  std::ofstream(folder_ / "file") << "x";
  EXPECT_NE(refusal(folder_ / "file" / "a.png").find("Not a directory"), std::string::npos);
}

TEST_F(PngFileTest, ADirectoryThatTakesNoFilesIsRefused) {
  // Not even root makes files here.
  EXPECT_FALSE(refusal("/proc/self/a.png").empty());
}

TEST_F(PngFileTest, NamesLeftBehindByAKilledProcessAreSteppedOver) {
  std::ofstream(folder_ / "a.png.part0") << "half";
  write_png(gradient(8, 8), folder_ / "a.png");
  EXPECT_EQ(read_png(folder_ / "a.png").rgb, gradient(8, 8).rgb);
  EXPECT_EQ(num_files(), 2);
}

}  // namespace
}  // namespace scanbed::sim
