// SPDX-License-Identifier: MIT
#include "scenarios/load/load_scenario.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

using testing::error_of;
using testing::kHead;
using testing::parse;
using testing::parse_error;

TEST(LoadScenarioTest, ReadsTheHeader) {
  const Scenario scenario = parse("description: a test\nseed: 7\nknown_fail: too far away\n");
  EXPECT_EQ(scenario.name, "test");
  EXPECT_EQ(scenario.description, "a test");
  EXPECT_EQ(scenario.seed, 7u);
  EXPECT_EQ(scenario.duration_s, 2.0);
  EXPECT_EQ(scenario.known_fail, "too far away");
}

TEST(LoadScenarioTest, ReplacesVariables) {
  const Scenario scenario = parse("world: [{id: c, cylinder: {at: [5, 5], r: $R}}]\nvars: {Q: 0.3, R: $Q}\n");
  EXPECT_EQ(std::get<sim::Cylinder>(scenario.world.solids.at(0).shape).radius_m, 0.3);
  EXPECT_EQ(parse_error("vars: {R: $Q, Q: 1}\n"),
            "f:4:11: R: unknown variable 'Q'; there are no known variables");
  EXPECT_EQ(parse_error("vars: {R: big}\n"), "f:4:11: R: expected a number, found 'big'");
}

TEST(LoadScenarioTest, SortsPictureTimes) {
  const Scenario scenario = parse("outputs: {pictures: {top: [2, 0.5], camera: [1], laser: [0]}}\n");
  EXPECT_EQ(scenario.pictures.top_s, (std::vector<double>{0.5, 2.0}));
  EXPECT_EQ(scenario.pictures.camera_s, (std::vector<double>{1.0}));
  EXPECT_EQ(scenario.pictures.laser_s, (std::vector<double>{0.0}));
  EXPECT_EQ(parse_error("outputs: {pictures: {top: [3]}}\n"),
            "f:4:28: top: value 3 is out of range; allowed: [0, 2]");
}

TEST(LoadScenarioTest, RefusesHeadersThatAreNotOurs) {
  const auto error = [](const std::string& text) { return error_of([&] { parse_scenario(text, "f"); }); };
  EXPECT_EQ(error(""), "f: is empty; expected a scenario");
  EXPECT_EQ(error("[1, 2]\n"), "f:1:1: scenario: expected a map of keys and values");
  EXPECT_EQ(error("name: a\nduration: 1\n"), "f:1:1: scenario: missing key 'schema'");
  EXPECT_EQ(error("schema: 2\nname: a\nduration: 1\n"), "f:1:9: schema: this version reads schema 1");
  EXPECT_EQ(error("schema: 1\nname: a/b\nduration: 1\n"),
            "f:2:7: name: expected letters, digits, _ and - only, found 'a/b'");
  EXPECT_EQ(error("schema: 1\nname: a\nduration: 0\n"),
            "f:3:11: duration: value 0 is out of range; allowed: (0, 86400]");
}

TEST(LoadScenarioTest, RefusesUnknownSections) {
  EXPECT_EQ(parse_error("sede: 3\n"), "f:4:1: unknown key 'sede'; did you mean 'seed'?");
  EXPECT_TRUE(parse_error("sweep: {seed: 1..20}\n").starts_with("f:4:1: unknown key 'sweep'"));
  EXPECT_EQ(parse_error("seed: 1\nseed: 2\n"), "f:5:1: duplicate key 'seed'; first on line 4");
}

TEST(LoadScenarioTest, SaysWhereAnImpossibleObjectStands) {
  const std::string twins = parse_error(
      "world:\n  - {id: a, cylinder: {at: [5, 5], r: 1}}\n  - {id: a, cylinder: {at: [9, 9], r: 1}}\n");
  EXPECT_TRUE(twins.starts_with("f:5:5: ")) << twins;
  EXPECT_NE(twins.find("'a'"), std::string::npos) << twins;
  const std::string clockwise = parse_error("world:\n  - {id: a, polygon: [[5, 5], [5, 6], [6, 5]]}\n");
  EXPECT_TRUE(clockwise.starts_with("f:5:5: solid 'a'")) << clockwise;
}

TEST(LoadScenarioTest, ChecksSettingsLikeTheFile) {
  const auto set = [](const std::string& path, const std::string& value) {
    const std::array<Setting, 1> settings = {Setting{path, value}};
    return parse_scenario(kHead, "f", settings);
  };
  EXPECT_EQ(set("sensor.noise.sigma", "0.02").lms.noise_sigma_m, 0.02);
  EXPECT_EQ(error_of([&] { set("sensor.nois.sigma", "0.02"); }),
            "--set sensor.nois.sigma=0.02: unknown key 'nois'; did you mean 'noise'?");
  EXPECT_EQ(error_of([&] { set("duration", "-1"); }),
            "--set duration=-1: duration: value -1 is out of range; allowed: (0, 86400]");
  EXPECT_EQ(error_of([&] { set("vars.r", "0.02"); }),
            "--set vars.r: there is no variable 'r'; there are no known variables");
  EXPECT_EQ(error_of([&] { set("include", "hall.yaml"); }),
            "--set include=hall.yaml: include: only a file includes others");
}

TEST(LoadScenarioTest, SettingsOfVariablesThatThereAreNotAreRefused) {
  const auto set = [](const std::string& path) {
    const std::array<Setting, 1> settings = {Setting{path, "0.02"}};
    return parse_scenario(kHead + "vars: {SIGMA: 0.01}\nsensor: {noise: {sigma: $SIGMA}}\n", "f", settings);
  };
  EXPECT_EQ(set("vars.SIGMA").lms.noise_sigma_m, 0.02);
  EXPECT_EQ(error_of([&] { set("vars.SIGM"); }),
            "--set vars.SIGM: there is no variable 'SIGM'; did you mean 'SIGMA'?");
}

TEST(LoadScenarioTest, ReadsFiles) {
  const testing::TemporaryFolder folder;
  EXPECT_EQ(load_scenario(testing::write_file(folder / "a.yaml", kHead)).name, "test");
  EXPECT_NE(error_of([&] { load_scenario(folder / "b.yaml"); }).find("no such file"), std::string::npos);
}

// Damage to a good file either leaves a good file or is refused in one line; nothing crashes.
RC_GTEST_PROP(LoadScenarioTest, SurvivesDamage, ()) {
  static const std::string good =
      testing::read_file(SCANBED_SOURCE_DIR "/scenarios/library/static_hallway.yaml");
  std::string text = good;
  const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
  const auto length = *rc::gen::inRange<std::size_t>(0, 30);
  text.replace(at, length,
               *rc::gen::container<std::string>(rc::gen::elementOf(std::string("{}[]:,-$0159.e\n ax&*!'"))));
  const std::string error = error_of([&] { parse_scenario(text, "f"); });
  RC_ASSERT(error.find('\n') == std::string::npos);
}

}  // namespace
}  // namespace scanbed::scenarios
