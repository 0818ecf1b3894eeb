// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "tests/scenarios/run_program.hpp"

namespace scanbed::scenarios {
namespace {

using testing::Outcome;
using testing::run_program;

// Width and height of a PNG, from its header: big-endian at bytes 16 and 20.
std::pair<int, int> size_of(const std::string& png) {
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value * 256 + static_cast<unsigned char>(png.at(i));
    return value;
  };
  return {number(16), number(20)};
}

TEST(RenderTest, WritesAPictureOfTheSizeAskedFor) {
  const testing::TemporaryFolder folder;
  const std::string file = (folder / "hall.png").string();
  for (const char* view : {"top", "camera", "laser"}) {
    const Outcome outcome = run_program(
        {"render", "static_hallway", "--at", "1.5", "--view", view, "-o", file, "--size", "320x200"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "picture: " + file + "\n");
    EXPECT_EQ(size_of(testing::read_file(file)), std::pair(320, 200)) << view;
  }
}

TEST(RenderTest, MakesFilmsOfAPartOfTheScenario) {
  if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) GTEST_SKIP() << "ffmpeg is not installed";
  const testing::TemporaryFolder folder;
  const std::string gif = (folder / "hall.gif").string();
  const std::string mp4 = (folder / "hall.mp4").string();
  const Outcome outcome = run_program(
      {"render", "static_hallway", "--view", "top",    "--grid", "polar", "--truth", "--labels", "--gif",
       gif,      "--mp4",          mp4,      "--from", "1",      "--to",  "2",       "--fps",    "3",
       "--size", "160x120"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "film: " + gif + "\nfilm: " + mp4 + "\n");
  EXPECT_EQ(testing::read_file(gif).substr(0, 6), "GIF89a");
  EXPECT_EQ(testing::read_file(mp4).substr(4, 4), "ftyp");
}

TEST(RenderTest, RefusesFilmsThatCannotBe) {
  const testing::TemporaryFolder folder;
  const std::string gif = (folder / "hall.gif").string();
  for (const std::vector<std::string>& flags : {std::vector<std::string>{"--from", "41"},
                                                {"--from", "3", "--to", "2"},
                                                {"--to", "99"},
                                                {"--fps", "0"},
                                                {"--fps", "1000"},
                                                {"--from", "x"}}) {
    std::vector<std::string> words{"render", "static_hallway", "--gif", gif};
    words.insert(words.end(), flags.begin(), flags.end());
    EXPECT_EQ(run_program(words).exit_code, 2) << flags[0] << " " << flags[1];
  }
  EXPECT_EQ(run_program({"render", "static_hallway"}).exit_code, 2);
  EXPECT_EQ(run_program({"render", "static_hallway", "--gif", "/nowhere/hall.gif"}).exit_code, 3);
}

TEST(RenderTest, RefusesTimesOfWhatIsNotWritten) {
  const testing::TemporaryFolder folder;
  for (const std::string flag : {"--from", "--to", "--fps"}) {
    const Outcome outcome =
        run_program({"render", "static_hallway", "-o", (folder / "hall.png").string(), flag, "5"});
    EXPECT_EQ(outcome.exit_code, 2) << flag;
    EXPECT_NE(outcome.err.find(flag + ": only for films"), std::string::npos) << outcome.err;
  }
  const Outcome outcome =
      run_program({"render", "static_hallway", "--gif", (folder / "hall.gif").string(), "--at", "5"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("--at: only for pictures"), std::string::npos) << outcome.err;
}

TEST(RenderTest, RefusesNamesOfOtherFormats) {
  const testing::TemporaryFolder folder;
  for (const auto& [flag, name, ending] :
       {std::array{"-o", "hall.jpg", "--out: expected a name that ends in .png"},
        {"--gif", "hall.mp4", "--gif: expected a name that ends in .gif"},
        {"--mp4", "hall.gif", "--mp4: expected a name that ends in .mp4"}}) {
    const std::string file = (folder / name).string();
    const Outcome outcome = run_program({"render", "static_hallway", flag, file});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err, "scanbed: error: " + std::string(ending) + ", found '" + file + "'\n");
    EXPECT_FALSE(std::filesystem::exists(file));
  }
  EXPECT_EQ(run_program({"render", "static_hallway", "-o", (folder / "HALL.PNG").string()}).exit_code, 0);
  EXPECT_EQ(run_program({"render", "static_hallway", "-o", (folder / "hall").string()}).exit_code, 0);
}

TEST(RenderTest, OverlaysChangeThePicture) {
  const testing::TemporaryFolder folder;
  const std::string file = (folder / "hall.png").string();
  std::set<std::string> pictures;
  for (const std::vector<std::string>& flags : {std::vector<std::string>{},
                                                {"--grid", "polar"},
                                                {"--grid", "cartesian"},
                                                {"--no-beams"},
                                                {"--no-features"},
                                                {"--truth"},
                                                {"--labels"}}) {
    std::vector<std::string> words{"render", "static_hallway", "-o", file, "--size", "320x240"};
    words.insert(words.end(), flags.begin(), flags.end());
    const Outcome outcome = run_program(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(pictures.insert(testing::read_file(file)).second) << (flags.empty() ? "" : flags[0]);
  }
}

TEST(RenderTest, RefusesMomentsOutsideTheScenario) {
  const testing::TemporaryFolder folder;
  const std::string file = (folder / "hall.png").string();
  const Outcome late = run_program({"render", "static_hallway", "--at", "41", "-o", file});
  EXPECT_EQ(late.exit_code, 2);
  EXPECT_NE(late.err.find("--at: value 41 is out of range; allowed: [0, 40]"), std::string::npos) << late.err;
  EXPECT_EQ(run_program({"render", "static_hallway", "--at", "-1", "-o", file}).exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(RenderTest, CallsWhatCannotBeWrittenAFault) {
  const testing::TemporaryFolder folder;
  for (const std::string& file : {std::string("/nowhere/a.png"), folder.path().string(),
                                  std::string("/dev/full"), std::string("/proc/self/a.png")}) {
    const Outcome outcome = run_program({"render", "static_hallway", "--size", "160x120", "-o", file});
    EXPECT_EQ(outcome.exit_code, 3) << file;
    EXPECT_NE(outcome.err.find(file + ": "), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("needs a directory"), std::string::npos) << outcome.err;
  }
}

TEST(RenderTest, WritesThroughALinkAndIntoADevice) {
  const testing::TemporaryFolder folder;
  testing::write_file(folder / "hall.png", "old");
  std::filesystem::create_symlink("hall.png", folder / "link.png");
  const Outcome linked =
      run_program({"render", "static_hallway", "--size", "160x120", "-o", (folder / "link.png").string()});
  EXPECT_EQ(linked.exit_code, 0) << linked.err;
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.png"));
  EXPECT_EQ(size_of(testing::read_file(folder / "hall.png")), std::pair(160, 120));
  EXPECT_EQ(run_program({"render", "static_hallway", "--size", "160x120", "-o", "/dev/null"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(RenderTest, WritesThePictureAloneToStandardOutput) {
  const Outcome outcome = run_program({"render", "static_hallway", "--size", "160x120", "-o", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(size_of(outcome.out), std::pair(160, 120));
  EXPECT_EQ(outcome.out.substr(outcome.out.size() - 8, 4), "IEND");
}

}  // namespace
}  // namespace scanbed::scenarios
