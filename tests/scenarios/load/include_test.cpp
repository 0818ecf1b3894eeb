// SPDX-License-Identifier: MIT
#include "scenarios/load/include.hpp"

#include <gtest/gtest.h>

#include "scenarios/load/load_scenario.hpp"
#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

using testing::kHead;
using testing::write_file;

class IncludeTest : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    return write_file(folder_ / name, text).string();
  }
  Scenario load(const std::string& rest) { return load_scenario(write("main.yaml", kHead + rest)); }
  std::string error(const std::string& rest) {
    return testing::error_of([&] { load(rest); });
  }

  testing::TemporaryFolder folder_;
};

TEST_F(IncludeTest, TakesTheWorldFromAFileAndChangesIt) {
  write("hall.yaml",
        "vars: {R: 0.25}\n"
        "world:\n"
        "  - {id: hall, walls: [[0, 0], [9, 0]]}\n"
        "  - {id: post, cylinder: {at: [3, 2], r: $R}, label: column}\n");
  const Scenario scenario = load(
      "include: hall.yaml\n"
      "vars: {R: 0.3}\n"
      "robot: {pose: [0, 3, 0]}\n"
      "world:\n"
      "  - {id: post, label: tree}\n"
      "  - {id: box, box: {at: [6, 2, 0], size: [1, 1]}}\n");
  ASSERT_EQ(scenario.world.solids.size(), 3u);
  EXPECT_EQ(scenario.world.solids[1].label, "tree");
  EXPECT_EQ(std::get<sim::Cylinder>(scenario.world.solids[1].shape).radius_m, 0.3);
  EXPECT_EQ(scenario.world.solids[2].id, "box");
}

TEST_F(IncludeTest, LaysLaterFilesOverEarlierOnes) {
  write("a.yaml", "seed: 1\ndescription: a\n");
  write("b.yaml", "seed: 2\n");
  const Scenario scenario = load("include: [a.yaml, b.yaml]\n");
  EXPECT_EQ(scenario.seed, 2u);
  EXPECT_EQ(scenario.description, "a");
}

TEST_F(IncludeTest, FollowsIncludesFromTheirOwnFolder) {
  std::filesystem::create_directory(folder_ / "parts");
  write("parts/inner.yaml", "seed: 7\n");
  write("parts/outer.yaml", "include: inner.yaml\n");
  write("empty.yaml", "# nothing\n");
  EXPECT_EQ(load("include: [parts/outer.yaml, empty.yaml]\n").seed, 7u);
}

TEST_F(IncludeTest, IncludesScenariosOfTheLibraryAlsoFromText) {
  const Scenario scenario =
      parse_scenario("include: static_hallway.yaml\nname: mine\nduration: 1\noutputs:\n", "f");
  EXPECT_EQ(scenario.name, "mine");
  EXPECT_GE(scenario.world.solids.size(), 3u);
}

TEST_F(IncludeTest, PlacesFaultsInTheFileWhereTheyStand) {
  const std::string bad = write("bad.yaml", "robot: {speed: 99}\n");
  EXPECT_EQ(error("include: bad.yaml\n"), std::filesystem::canonical(bad).string() +
                                              ":1:16: speed: value 99 is out of range; allowed: (0, 5]");
}

TEST_F(IncludeTest, RefusesCyclesAtThePlaceWhereTheyClose) {
  const std::string a = write("a.yaml", "include: b.yaml\n");
  const std::string b = write("b.yaml", "\ninclude: a.yaml\n");
  EXPECT_EQ(error("include: a.yaml\n"),
            std::filesystem::canonical(b).string() + ":2:10: 'a.yaml' includes itself");
}

TEST_F(IncludeTest, RefusesAThousandFilesWithOneError) {
  std::string names;
  for (int i = 0; i < 1000; ++i) {
    const std::string name = "part_" + std::to_string(i) + ".yaml";
    write(name, "seed: 1\n");
    names += (i == 0 ? "" : ", ") + name;
  }
  const std::string message = error("include: [" + names + "]\n");
  EXPECT_NE(message.find(": too many includes; allowed: 32 files"), std::string::npos) << message;
}

TEST_F(IncludeTest, RefusesATreeOfIncludesThatDoubles) {
  for (int i = 0; i < 7; ++i) {
    const std::string next = "level_" + std::to_string(i + 1) + ".yaml";
    write("level_" + std::to_string(i) + ".yaml", "include: [" + next + ", " + next + "]\n");
  }
  write("level_7.yaml", "seed: 1\n");
  EXPECT_NE(error("include: level_0.yaml\n").find("too many includes"), std::string::npos);
}

TEST_F(IncludeTest, BoundsDepthAndSize) {
  for (int i = 0; i < 9; ++i) {
    write("deep_" + std::to_string(i) + ".yaml", "include: deep_" + std::to_string(i + 1) + ".yaml\n");
  }
  EXPECT_NE(error("include: deep_0.yaml\n").find("includes nest too deeply; allowed: 8 levels"),
            std::string::npos);
  std::string list = "drive: [1";
  for (int i = 0; i < 19'000; ++i) list += ", 1";
  write("wide.yaml", list + "]\n");
  EXPECT_NE(error("include: [wide.yaml, wide.yaml, wide.yaml, wide.yaml]\n").find("too many values included"),
            std::string::npos);
}

TEST_F(IncludeTest, RefusesWhatIsNoFileName) {
  EXPECT_NE(error("include: {a: 1}\n").find(":4:10: include: expected text, found a map"), std::string::npos);
  EXPECT_NE(error("include: [[a]]\n").find("include: expected text, found a list"), std::string::npos);
  write("list.yaml", "[1, 2]\n");
  EXPECT_NE(error("include: list.yaml\n").find(":1:1: expected a map of keys and values"), std::string::npos);
}

}  // namespace
}  // namespace scanbed::scenarios
