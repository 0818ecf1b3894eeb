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
  return detector_settings({}, settings).options.detector;
}

TEST(DetectorSettingsTest, AreRobustByDefault) {
  EXPECT_EQ(detector_settings({}, {}).options.detector.pipeline, Pipeline::kRobust);
}

TEST(DetectorSettingsTest, TakeTableTwosNamesAndUnits) {
  EXPECT_DOUBLE_EQ(with("seg_threshold", "100").segmentation.max_gap_m, 0.1);  // mm
  EXPECT_DOUBLE_EQ(with("line_err", "0.02").line.max_error_m, 0.02);           // m
  EXPECT_FALSE(with("legs", "0").leg.enabled);
  EXPECT_TRUE(is_detector_setting("circle_std_max"));
  EXPECT_FALSE(is_detector_setting("seed"));
}

TEST(DetectorSettingsTest, ReadAFileAndLetSettingsOverrideIt) {
  const testing::TemporaryFolder folder;
  const auto file = testing::write_file(folder / "d.yaml", "seg_threshold: 100\nline_err: 0.02\n");
  const std::array<Setting, 1> settings = {Setting{"line_err", "0.03"}};
  const DetectorOptions options =
      detector_settings({.preset = "paper", .config = file}, settings).options.detector;
  EXPECT_DOUBLE_EQ(options.segmentation.max_gap_m, 0.1);
  EXPECT_DOUBLE_EQ(options.line.max_error_m, 0.03);
}

TEST(DetectorSettingsTest, SayWhereABadParameterStands) {
  const testing::TemporaryFolder folder;
  const auto error = [&](const std::string& text) {
    const auto file = testing::write_file(folder / "d.yaml", text);
    const std::string message = error_of([&] { detector_settings({.preset = "paper", .config = file}, {}); });
    return message.substr(std::min(message.size(), file.string().size()));
  };
  EXPECT_EQ(error("lines: 1\nline_er: 0.02\n"), ":2:1: unknown key 'line_er'; did you mean 'line_err'?");
  EXPECT_TRUE(error("line_min_pts: 1\n").starts_with(":1:15: line_min_pts")) << error("line_min_pts: 1\n");
  EXPECT_EQ(error("line_err: thin\n"), ":1:11: line_err: expected a number, found 'thin'");
  EXPECT_TRUE(
      error_of([] { with("seg_threshold", "-5"); }).starts_with("--set seg_threshold=-5: seg_threshold"));
}

TEST(DetectorSettingsTest, KnowOnlyThePreset) {
  EXPECT_EQ(detector_settings({.preset = "paper", .config = {}}, {}).options.detector.pipeline,
            Pipeline::kPaper);
  EXPECT_EQ(error_of([] { detector_settings({.preset = "papre", .config = {}}, {}); }),
            "--preset: unknown value 'papre'; did you mean 'paper'?");
}

TEST(DetectorSettingsTest, TakeOptionsOfAllGroupsByTheirPath) {
  const testing::TemporaryFolder folder;
  const auto file = testing::write_file(folder / "d.yaml",
                                        "line: {min_length_m: 0.4, method: off}\n"
                                        "track:\n  gate_m: 0.2\n  motion: still\n"
                                        "interpret: {max_door_m: 2}\nleg: {enabled: false}\n");
  const AnalysisOptions options = detector_settings({.config = file}, {}).options;
  EXPECT_EQ(options.detector.line.min_length_m, 0.4);
  EXPECT_EQ(options.detector.line.method, LineMethod::kOff);
  EXPECT_FALSE(options.detector.leg.enabled);
  EXPECT_EQ(options.track.gate_m, 0.2);
  EXPECT_EQ(options.track.motion, MotionSource::kStill);
  EXPECT_EQ(options.interpret.max_door_m, 2.0);
  EXPECT_EQ(with("surface.arc_price", "24").surface.arc_price, 24.0);
  EXPECT_TRUE(is_detector_setting("track.gate_m"));
  EXPECT_TRUE(is_detector_setting("track.gaet_m"));  // so that its error names the nearest option
  EXPECT_TRUE(is_detector_setting("pipeline"));
  EXPECT_FALSE(is_detector_setting("sensor.noise.sigma"));
}

TEST(DetectorSettingsTest, SayWhereABadOptionStands) {
  const testing::TemporaryFolder folder;
  const auto error = [&](const std::string& text) {
    const auto file = testing::write_file(folder / "d.yaml", text);
    const std::string message = error_of([&] { detector_settings({.config = file}, {}); });
    return message.substr(std::min(message.size(), file.string().size()));
  };
  EXPECT_TRUE(error("track:\n  gate_m: -1\n").starts_with(":2:11: track.gate_m: value -1 is out of range"))
      << error("track:\n  gate_m: -1\n");
  EXPECT_EQ(error("track: {gaet_m: 1}\n"), ":1:9: unknown key 'gaet_m'; did you mean 'gate_m'?");
  EXPECT_TRUE(error("leg: {enabled: 2}\n").starts_with(":1:16: enabled:"));
  EXPECT_TRUE(error("line: {min_points: 4.5}\n").starts_with(":1:20: min_points:"));
  EXPECT_TRUE(error("line: {method: fast}\n").starts_with(":1:16: method:"));
}

// max_door_m is 2.5 by itself.
TEST(DetectorSettingsTest, WhatFitsTogetherMayComeInAnyOrder) {
  const Setting least{"interpret.min_door_m", "3"};
  const Setting most{"interpret.max_door_m", "4"};
  for (const auto& settings : {std::array{least, most}, {most, least}}) {
    EXPECT_EQ(detector_settings({}, settings).options.interpret.min_door_m, 3.0);
  }
  const testing::TemporaryFolder folder;
  const auto file = testing::write_file(folder / "d.yaml", "interpret: {min_door_m: 3}\n");
  EXPECT_EQ(detector_settings({.config = file}, std::array{most}).options.interpret.min_door_m, 3.0);
  const std::array<Setting, 3> too_low = {most, least, Setting{"interpret.max_door_m", "2"}};
  EXPECT_TRUE(error_of([&] {
                detector_settings({}, too_low);
              }).starts_with("--set interpret.max_door_m=2: interpret.max_door_m"));
}

TEST(DetectorSettingsTest, NameWhatThePipelineDoesNotRead) {
  const std::array<Setting, 3> settings = {Setting{"circle_std_max", "0.1"}, Setting{"line_min_pts", "6"},
                                           Setting{"surface.arc_price", "20"}};
  EXPECT_EQ(detector_settings({}, settings).idle,
            (std::vector<IdleOption>{{"circle_std_max", "the paper pipeline"}}));
  EXPECT_EQ(detector_settings({.preset = "paper", .config = {}}, settings).idle,
            (std::vector<IdleOption>{{"surface.arc_price", "the robust pipeline"}}));
}

TEST(DetectorSettingsTest, NameWhatOnlyTheRulesForLegsRead) {
  std::vector<Setting> settings = {Setting{"seg_threshold", "90"}, Setting{"leg.min_points", "4"}};
  EXPECT_EQ(detector_settings({}, settings).idle,
            (std::vector<IdleOption>{{"seg_threshold", "the paper pipeline or leg.scorer: rules"},
                                     {"leg.min_points", "leg.scorer: rules"}}));
  EXPECT_TRUE(detector_settings({.preset = "paper", .config = {}}, settings).idle.empty());
  settings.push_back({"leg.scorer", "rules"});
  EXPECT_TRUE(detector_settings({}, settings).idle.empty()) << "a later setting makes them count";
}

TEST(DetectorSettingsTest, NameWhatNoStepReads) {
  const std::array<Setting, 2> settings = {Setting{"track.gate_m", "0.2"},
                                           Setting{"interpret.min_door_m", "1"}};
  const auto idle = [&](const AnalysisSteps& steps) { return detector_settings({}, settings, steps).idle; };
  const IdleOption tracking{"track.gate_m", "tracking"};
  const IdleOption interpretation{"interpret.min_door_m", "the interpretation of scenes"};
  EXPECT_EQ(idle({.tracks = false, .interprets = false}), (std::vector{tracking, interpretation}));
  EXPECT_EQ(idle({.tracks = true, .interprets = false}), std::vector{interpretation});
  EXPECT_TRUE(idle({.tracks = false, .interprets = true}).empty()) << "interpretation asks what moves";
}

// The file as `scanbed options` prints it serves every command.
TEST(DetectorSettingsTest, AFileMayHoldWhatThisRunDoesNotRead) {
  const testing::TemporaryFolder folder;
  const auto file = testing::write_file(folder / "d.yaml", options_yaml({}, {}));
  EXPECT_TRUE(detector_settings({.config = file}, {}, {.tracks = false, .interprets = false}).idle.empty());
}

TEST(DetectorSettingsTest, RefuseAFileOfAnotherPreset) {
  const testing::TemporaryFolder folder;
  const auto file = testing::write_file(folder / "d.yaml", "\npipeline: paper\n");
  EXPECT_EQ(error_of([&] { detector_settings({.preset = "robust", .config = file}, {}); }),
            file.string() + ":2:11: pipeline: is paper, but --preset is robust; allowed: one of the two");
  for (const std::optional<std::string>& preset : {std::optional<std::string>("paper"), {}}) {
    EXPECT_EQ(preset_of(detector_settings({.preset = preset, .config = file}, {}).options), "paper");
  }
}

TEST(DetectorSettingsTest, APipelineBringsThePresetsValuesWithIt) {
  const DetectorOptions paper = detector_settings({.preset = "paper", .config = {}}, {}).options.detector;
  const testing::TemporaryFolder folder;
  const auto file = testing::write_file(folder / "d.yaml", "circle_std_max: 0.1\npipeline: paper\n");
  const DetectorOptions from_file = detector_settings({.config = file}, {}).options.detector;
  EXPECT_EQ(from_file.leg.scorer, paper.leg.scorer);
  EXPECT_EQ(from_file.line.min_length_m, paper.line.min_length_m);
  EXPECT_EQ(from_file.circle.max_std_rad, 0.1);
  const std::array settings = {Setting{"circle_std_max", "0.1"}, Setting{"pipeline", "paper"}};
  EXPECT_EQ(detector_settings({}, settings).options.detector.leg.scorer, paper.leg.scorer);
  EXPECT_EQ(detector_settings({}, settings).options.detector.circle.max_std_rad, 0.1);
  // The last one counts.
  EXPECT_EQ(preset_of(detector_settings({.config = file}, std::array{Setting{"pipeline", "robust"}}).options),
            "robust");
}

TEST(DetectorSettingsTest, RefuseASettingOfAnotherPreset) {
  EXPECT_EQ(error_of([&] {
              detector_settings({.preset = "robust", .config = {}}, std::array{Setting{"pipeline", "paper"}});
            }),
            "--set pipeline=paper: pipeline: is paper, but --preset is robust; allowed: one of the two");
}

TEST(DetectorSettingsTest, RefuseAnOptionUnderBothItsNames) {
  const testing::TemporaryFolder folder;
  const auto file =
      testing::write_file(folder / "d.yaml", "segmentation: {max_gap_m: 0.1}\nseg_threshold: 300\n");
  EXPECT_EQ(error_of([&] { detector_settings({.config = file}, {}); }),
            file.string() +
                ":1:27: segmentation.max_gap_m: is seg_threshold by another name, which is given on line 2");
}

TEST(DetectorSettingsTest, RefuseAFileWithoutOptions) {
  const testing::TemporaryFolder folder;
  for (const char* text : {"", "# line_err: 0.02\n", "---\n"}) {
    const auto file = testing::write_file(folder / "d.yaml", text);
    EXPECT_EQ(error_of([&] { detector_settings({.config = file}, {}); }),
              file.string() + ": is empty; expected options, see 'scanbed options'");
  }
  const auto file = testing::write_file(folder / "d.yaml", "line_err: 0.02\n---\nline_err: 0.03\n");
  EXPECT_TRUE(error_of([&] {
                detector_settings({.config = file}, {});
              }).starts_with(file.string() + ":3:1: a second document"));
}

}  // namespace
}  // namespace scanbed::scenarios
