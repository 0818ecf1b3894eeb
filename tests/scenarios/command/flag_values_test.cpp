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
  EXPECT_EQ(error_of([] { to_count("--limit", "-1", 0); }), "--limit: expected a whole number, found '-1'");
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
      check_all_differ(
          std::array{FileToWrite{"--out", out}, FileToWrite{"--json", {}}, FileToWrite{"--record", record}});
    });
  };
  EXPECT_EQ(error("b.jsonl", "b.jsonl"), "--record: b.jsonl: is the file of --out, too; name another one");
  EXPECT_NE(error("b.jsonl", std::filesystem::current_path() / "b.jsonl"), "");
  EXPECT_NE(error(folder / "a", folder / "link"), "");
  EXPECT_NE(error(folder / "new", folder / "./new"), "");
  EXPECT_EQ(error(folder / "a", folder / "b"), "");
  EXPECT_EQ(error("/dev/null", "/dev/null"), "");
}

}  // namespace
}  // namespace scanbed::scenarios
