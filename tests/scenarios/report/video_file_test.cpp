// SPDX-License-Identifier: MIT
#include "scenarios/report/video_file.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "scenarios/run/output.hpp"
#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

bool has_ffmpeg() {
  return std::system("ffmpeg -version > /dev/null 2>&1") == 0;
}

sim::Image plain(int width_px, int height_px, std::uint8_t value) {
  return {width_px, height_px, std::vector<std::uint8_t>(std::size_t{3} * width_px * height_px, value)};
}

TEST(VideoFileTest, AGifHasItsSizeInItsHeader) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const testing::TemporaryFolder folder;
  VideoFile film(folder / "film.gif", {VideoFormat::kGif, 80, 64, 5.0});
  for (int k = 0; k < 4; ++k) film.write(plain(80, 64, static_cast<std::uint8_t>(60 * k)));
  EXPECT_FALSE(std::filesystem::exists(folder / "film.gif"));
  film.finish();
  const std::string bytes = testing::read_file((folder / "film.gif").string());
  ASSERT_GT(bytes.size(), 10U);
  EXPECT_EQ(bytes.substr(0, 6), "GIF89a");
  EXPECT_EQ(bytes[6] + 256 * bytes[7], 80);
  EXPECT_EQ(bytes[8] + 256 * bytes[9], 64);
}

TEST(VideoFileTest, AnMp4TakesOddSizes) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const testing::TemporaryFolder folder;
  VideoFile film(folder / "film.mp4", {VideoFormat::kMp4, 81, 65, 5.0});
  for (int k = 0; k < 4; ++k) film.write(plain(81, 65, 128));
  film.finish();
  EXPECT_EQ(testing::read_file((folder / "film.mp4").string()).substr(4, 4), "ftyp");
}

TEST(VideoFileTest, WhatIsNotFinishedLeavesNothingBehind) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const testing::TemporaryFolder folder;
  {
    VideoFile film(folder / "film.gif", {VideoFormat::kGif, 80, 64, 5.0});
    film.write(plain(80, 64, 0));
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "."), {}), 0);
}

TEST(VideoFileTest, FailsWhereTheFolderIsMissing) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  EXPECT_THROW(VideoFile("/nowhere/film.mp4", {VideoFormat::kMp4, 80, 64, 5.0}), OutputFault);
}

TEST(VideoFileTest, WritesThroughALinkAndIntoADevice) {
  if (!has_ffmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  const testing::TemporaryFolder folder;
  testing::write_file(folder / "film.gif", "old");
  std::filesystem::create_symlink("film.gif", folder / "link.gif");
  std::filesystem::create_symlink("/dev/null", folder / "device.gif");
  for (const char* name : {"link.gif", "device.gif"}) {
    VideoFile film(folder / name, {VideoFormat::kGif, 80, 64, 5.0});
    film.write(plain(80, 64, 0));
    film.finish();
    EXPECT_TRUE(std::filesystem::is_symlink(folder / name)) << name;
  }
  EXPECT_EQ(testing::read_file(folder / "film.gif").substr(0, 6), "GIF89a");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(VideoFileTest, WithoutFfmpegItSaysWhatToInstall) {
  const char* before = std::getenv("PATH");
  const std::string path = before == nullptr ? "" : before;
  ::setenv("PATH", "/nowhere", 1);
  try {
    VideoFile film("film.gif", {VideoFormat::kGif, 80, 64, 5.0});
    ADD_FAILURE() << "no error";
  } catch (const OutputFault& fault) {
    EXPECT_NE(std::string(fault.what()).find("package ffmpeg"), std::string::npos) << fault.what();
  }
  ::setenv("PATH", path.c_str(), 1);
}

}  // namespace
}  // namespace scanbed::scenarios
