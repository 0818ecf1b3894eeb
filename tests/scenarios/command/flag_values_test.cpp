// SPDX-License-Identifier: MIT
#include "scenarios/command/flag_values.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

using testing::error_of;

TEST(FlagValuesTest, ReadCountsTimesAndPaths) {
  EXPECT_EQ(to_count("--limit", "12", 1), 12);
  EXPECT_EQ(to_time_s("--at", "2.5"), 2.5);
  EXPECT_EQ(to_path("a/b"), std::filesystem::path("a/b"));
  EXPECT_EQ(to_path(""), std::nullopt);
}

TEST(FlagValuesTest, NameTheFlagAndTheTextThatDoesNotFit) {
  EXPECT_EQ(error_of([] { to_count("--limit", "many", 1); }),
            "--limit: expected a whole number, found 'many'");
  EXPECT_EQ(error_of([] { to_count("--limit", "-1", 0); }),
            "--limit: value -1 is out of range; allowed: >= 0");
  EXPECT_EQ(error_of([] { to_count("--seed", "9223372036854775808", 0); }),
            "--seed: value 9223372036854775808 is out of range; allowed: [0, 9223372036854775807]");
  EXPECT_EQ(error_of([] { to_count("--limit", "0", 1); }), "--limit: value 0 is out of range; allowed: >= 1");
  EXPECT_EQ(error_of([] { to_time_s("--at", ""); }), "--at: expected seconds, found ''");
}

TEST(FlagValuesTest, ChooseAmongNamesAndHintAtTheNearest) {
  const std::array<std::string, 2> views = {"top", "camera"};
  EXPECT_EQ(to_choice("--view", "camera", views, "views"), 1u);
  EXPECT_EQ(error_of([&] { to_choice("--view", "camra", views, "views"); }),
            "--view: unknown value 'camra'; did you mean 'camera'?");
}

TEST(FlagValuesTest, RefuseOneFileForTwoOutputs) {
  const testing::TemporaryFolder folder;
  testing::write_file(folder / "a", "");
  std::filesystem::create_symlink("a", folder / "link");
  const auto error = [&](const std::filesystem::path& out, const std::filesystem::path& record) {
    return error_of([&] {
      check_files(std::array{FlagFile{"--out", out}, FlagFile{"--json", {}}, FlagFile{"--record", record}},
                  {});
    });
  };
  EXPECT_EQ(error("b.jsonl", "b.jsonl"), "--record: b.jsonl: is the file of --out, too; name another one");
  EXPECT_NE(error("b.jsonl", std::filesystem::current_path() / "b.jsonl"), "");
  EXPECT_NE(error(folder / "a", folder / "link"), "");
  EXPECT_NE(error(folder / "new", folder / "./new"), "");
  EXPECT_EQ(error(folder / "a", folder / "b"), "");
  EXPECT_EQ(error("/dev/null", "/dev/null"), "");
  std::filesystem::create_symlink("to_come", folder / "dangling");
  EXPECT_NE(error(folder / "to_come", folder / "dangling"), "");
}

TEST(FlagValuesTest, RefuseAResultOverWhatIsRead) {
  const testing::TemporaryFolder folder;
  testing::write_file(folder / "a", "");
  const auto error = [&](const std::filesystem::path& out, const std::filesystem::path& read) {
    return error_of([&] {
      check_files(std::array{FlagFile{"--out", out}}, std::array{FlagFile{"--laser", read}});
    });
  };
  EXPECT_EQ(error("a.log", "./a.log"), "--out: a.log: is what --laser reads; name another one");
  EXPECT_EQ(error(folder / "b", folder / "a"), "");
  EXPECT_EQ(error("/dev/null", "/dev/null"), "");
}

TEST(FlagValuesTest, ALaserThatReadsAFileNamesIt) {
  EXPECT_EQ(laser_file(parse_laser_spec("log:a.log?from=2")).path, "a.log");
  const testing::TemporaryFolder folder;
  const std::string mine = testing::write_file(folder / "mine.yaml", "");
  EXPECT_EQ(laser_file(parse_laser_spec("sim:" + mine)).path, mine);
  EXPECT_EQ(laser_file(parse_laser_spec("sim:static_hallway")).path, std::nullopt);  // of the library
  EXPECT_EQ(laser_file(parse_laser_spec("sim")).path, std::nullopt);
  EXPECT_EQ(laser_file(parse_laser_spec("sick:/dev/ttyUSB0")).path, std::nullopt);
}

TEST(FlagValuesTest, RefuseStandardOutputWhereAFileIsNeeded) {
  EXPECT_EQ(error_of([] { to_file("--truth", "-"); }), "--truth: cannot be standard output; name a file");
  EXPECT_EQ(to_file("--truth", "t"), "t");
  EXPECT_EQ(to_file("--truth", ""), std::nullopt);
}

}  // namespace
}  // namespace scanbed::scenarios
