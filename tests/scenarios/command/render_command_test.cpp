// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

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

TEST(RenderTest, RefusesMomentsOutsideTheScenario) {
  const testing::TemporaryFolder folder;
  const std::string file = (folder / "hall.png").string();
  const Outcome late = run_program({"render", "static_hallway", "--at", "41", "-o", file});
  EXPECT_EQ(late.exit_code, 2);
  EXPECT_NE(late.err.find("--at: value 41 is out of range; allowed: [0, 40]"), std::string::npos) << late.err;
  EXPECT_EQ(run_program({"render", "static_hallway", "--at", "-1", "-o", file}).exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(RenderTest, CallsAFolderThatIsNotThereAFault) {
  const Outcome outcome = run_program({"render", "static_hallway", "-o", "/nowhere/a.png"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("/nowhere"), std::string::npos);
}

}  // namespace
}  // namespace scanbed::scenarios
