// SPDX-License-Identifier: MIT
#include "scenarios/run/detector_settings.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

using testing::error_of;

DetectorOptions with(const std::string& name, const std::string& value) {
  const std::array<Setting, 1> settings = {Setting{name, value}};
  return detector_options({}, settings);
}

TEST(DetectorOptionsTest, AreThePapersByDefault) {
  EXPECT_EQ(detector_options({}, {}).segmentation.max_gap_m, paper_options().segmentation.max_gap_m);
}

TEST(DetectorOptionsTest, TakeTableTwosNamesAndUnits) {
  EXPECT_DOUBLE_EQ(with("seg_threshold", "100").segmentation.max_gap_m, 0.1);  // mm
  EXPECT_DOUBLE_EQ(with("line_err", "0.02").line.max_error_m, 0.02);           // m
  EXPECT_FALSE(with("legs", "0").leg.enabled);
  EXPECT_TRUE(is_table_two_name("circle_std_max"));
  EXPECT_FALSE(is_table_two_name("seed"));
}

TEST(DetectorOptionsTest, ReadAFileAndLetSettingsOverrideIt) {
  const testing::TemporaryFolder folder;
  const auto file = testing::write_file(folder / "d.yaml", "seg_threshold: 100\nline_err: 0.02\n");
  const std::array<Setting, 1> settings = {Setting{"line_err", "0.03"}};
  const DetectorOptions options = detector_options({.preset = "paper", .config = file}, settings);
  EXPECT_DOUBLE_EQ(options.segmentation.max_gap_m, 0.1);
  EXPECT_DOUBLE_EQ(options.line.max_error_m, 0.03);
}

TEST(DetectorOptionsTest, SayWhereABadParameterStands) {
  const testing::TemporaryFolder folder;
  const auto error = [&](const std::string& text) {
    const auto file = testing::write_file(folder / "d.yaml", text);
    const std::string message = error_of([&] { detector_options({.preset = "paper", .config = file}, {}); });
    return message.substr(std::min(message.size(), file.string().size()));
  };
  EXPECT_EQ(error("lines: 1\nline_er: 0.02\n"), ":2:1: unknown key 'line_er'; did you mean 'line_err'?");
  EXPECT_TRUE(error("line_min_pts: 1\n").starts_with(":1:15: line_min_pts")) << error("line_min_pts: 1\n");
  EXPECT_EQ(error("line_err: thin\n"), ":1:11: line_err: expected a number, found 'thin'");
  EXPECT_TRUE(
      error_of([] { with("seg_threshold", "-5"); }).starts_with("--set seg_threshold=-5: seg_threshold"));
}

TEST(DetectorOptionsTest, KnowOnlyThePreset) {
  EXPECT_EQ(detector_options({.preset = "robust", .config = {}}, {}).pipeline, Pipeline::kRobust);
  EXPECT_EQ(error_of([] { detector_options({.preset = "papre", .config = {}}, {}); }),
            "--preset: unknown value 'papre'; did you mean 'paper'?");
}

}  // namespace
}  // namespace scanbed::scenarios
