// SPDX-License-Identifier: MIT
#include "scenarios/command/command_line.hpp"

#include <gtest/gtest.h>

#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

Command parsed(std::vector<const char*> words) {
  words.insert(words.begin(), "scanbed");
  return parse_command_line(static_cast<int>(words.size()), words.data());
}

std::string usage_error(const std::vector<const char*>& words) {
  return testing::error_of([&] { parsed(words); });
}

TEST(CommandLineTest, ReadsEveryFlagOfRun) {
  const auto run = std::get<RunCommand>(
      parsed({"run",   "a",   "--laser", "log:f",    "--seed", "9007199254740993", "b",
              "--set", "x=1", "c",       "--set",    "y=2",    "--json",           "-",
              "--out", "dir", "--quiet", "--config", "cfg",    "--preset",         "paper"}));
  EXPECT_EQ(run.scenarios, (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(run.laser.target, "f");
  ASSERT_TRUE(run.seeds);
  EXPECT_EQ(run.seeds->first, 9007199254740993u);
  EXPECT_EQ(run.seeds->last, 9007199254740993u);
  ASSERT_EQ(run.settings.size(), 2u);
  EXPECT_EQ(run.settings[1].path, "y");
  EXPECT_EQ(run.json, "-");
  EXPECT_EQ(run.out, "dir");
  EXPECT_TRUE(run.quiet);
  EXPECT_EQ(run.detector.config, "cfg");
}

TEST(CommandLineTest, RunsTheWholeLibraryByPattern) {
  const auto run =
      std::get<RunCommand>(parsed({"run", "--all", "--seed", "3..7", "--jobs", "2", "--tables"}));
  EXPECT_EQ(run.scenarios, std::vector<std::string>{"*"});
  EXPECT_EQ(run.seeds->count(), 5);
  EXPECT_EQ(run.num_workers, 2);
  EXPECT_TRUE(run.tables);
  EXPECT_EQ(usage_error({"run", "--all", "a"}), "--all: goes without scenarios; found 'a'");
  EXPECT_EQ(usage_error({"run"}), "SCENARIO is required; see 'scanbed run --help'");
}

TEST(CommandLineTest, RunsTheScenariosOwnSeedInTheSimulationByDefault) {
  const auto run = std::get<RunCommand>(parsed({"run", "a"}));
  EXPECT_EQ(run.laser.kind, LaserKind::kSimulated);
  EXPECT_FALSE(run.seeds.has_value());
  EXPECT_FALSE(run.json.has_value());
  EXPECT_FALSE(run.out.has_value());
  EXPECT_FALSE(run.quiet);
  EXPECT_FALSE(run.detector.preset);
}

TEST(CommandLineTest, ReadsDetectRenderListAndValidate) {
  const auto detect =
      std::get<DetectCommand>(parsed({"detect", "--laser", "log:f", "--limit", "3", "--out", "o"}));
  EXPECT_EQ(detect.limit, 3);
  EXPECT_EQ(detect.out, "o");
  const auto render = std::get<RenderCommand>(parsed(
      {"render", "a", "--at", "2.5", "--view", "top", "-o", "f.png", "--size", "320x240", "--seed", "4"}));
  EXPECT_EQ(render.at_s, 2.5);
  EXPECT_EQ(render.picture.view, sim::View::kTop);
  EXPECT_EQ(render.picture.width_px, 320);
  EXPECT_EQ(render.picture.height_px, 240);
  EXPECT_EQ(render.out, "f.png");
  EXPECT_EQ(render.seed, 4u);
  EXPECT_TRUE(std::holds_alternative<ListCommand>(parsed({"list"})));
  EXPECT_EQ(std::get<ValidateCommand>(parsed({"validate", "a", "b"})).scenarios.size(), 2u);
}

TEST(CommandLineTest, AnswersHelpAndVersionWithText) {
  EXPECT_EQ(std::get<TextCommand>(parsed({"--version"})).text, "scanbed " SCANBED_TEST_VERSION "\n");
  for (const char* command :
       {"run", "detect", "render", "convert", "export", "emulate", "devices", "list", "validate"}) {
    const std::string help = std::get<TextCommand>(parsed({command, "--help"})).text;
    EXPECT_NE(help.find("scanbed " + std::string(command)), std::string::npos) << help;
  }
  // All of Table II's names can be looked up.
  EXPECT_NE(std::get<TextCommand>(parsed({"detect", "--help"})).text.find("circle_std_max"),
            std::string::npos);
}

TEST(CommandLineTest, SaysWhatIsWrongAndWhereTheHelpIs) {
  EXPECT_NE(usage_error({}).find("see 'scanbed --help'"), std::string::npos);
  EXPECT_NE(usage_error({"run"}).find("see 'scanbed run --help'"), std::string::npos);
  EXPECT_NE(usage_error({"detect"}).find("--laser is required"), std::string::npos);
  EXPECT_NE(usage_error({"run", "a", "--sed", "1"}).find("--sed"), std::string::npos);
  EXPECT_EQ(usage_error({"rnu"}), "unknown command 'rnu'; did you mean 'run'?; see 'scanbed --help'");
}

TEST(CommandLineTest, NamesAnUnknownOptionBeforeWhatIsMissing) {
  EXPECT_EQ(usage_error({"--foo"}), "unknown option '--foo'; see 'scanbed --help'");
  EXPECT_EQ(usage_error({"--verson"}),
            "unknown option '--verson'; did you mean '--version'?; see 'scanbed --help'");
  EXPECT_EQ(usage_error({"detect", "--traks"}),
            "unknown option '--traks'; did you mean '--track'?; see 'scanbed detect --help'");
  EXPECT_EQ(usage_error({"run", "a", "--sed=1"}),
            "unknown option '--sed'; did you mean '--seed'?; see 'scanbed run --help'");
  EXPECT_EQ(usage_error({"list", "all"}), "unexpected argument 'all'; see 'scanbed list --help'");
}

TEST(CommandLineTest, HelpIsACommandToo) {
  const auto text = [](const std::vector<const char*>& words) {
    return std::get<TextCommand>(parsed(words)).text;
  };
  EXPECT_EQ(text({"help"}), text({"--help"}));
  EXPECT_EQ(text({"help", "run"}), text({"run", "--help"}));
  EXPECT_EQ(usage_error({"help", "rnu"}), "unknown command 'rnu'; did you mean 'run'?; see 'scanbed --help'");
}

TEST(CommandLineTest, RefusesEmptyValues) {
  for (const char* flag : {"--record", "--out", "--json", "--config"}) {
    const std::string error = usage_error({"run", "a", flag, ""});
    EXPECT_TRUE(error.starts_with(std::string(flag) + ": expected ")) << error;
    EXPECT_TRUE(error.ends_with(", found ''; see 'scanbed run --help'")) << error;
  }
  EXPECT_EQ(usage_error({"run", "a", "--seed", ""}),
            "--seed: expected N|A..B, found ''; see 'scanbed run --help'");
  EXPECT_TRUE(usage_error({"run", "a", "--out="}).starts_with("--out: ")) << "CLI11 has its own words here";
  EXPECT_EQ(usage_error({"export", "a", "--mjcf", ""}),
            "--mjcf: expected FILE, found ''; see 'scanbed export --help'");
  EXPECT_EQ(usage_error({"run", ""}), "SCENARIO: expected a value, found ''; see 'scanbed run --help'");
}

TEST(CommandLineTest, AnEmulatedSensorHasAnyAddressThatTheHelpTells) {
  const std::string help = std::get<TextCommand>(parsed({"emulate", "--help"})).text;
  EXPECT_NE(help.find("0 to 127"), std::string::npos) << help;
  EXPECT_EQ(std::get<EmulateCommand>(parsed({"emulate", "a", "--address", "127"})).address, 127);
  EXPECT_EQ(usage_error({"emulate", "a", "--address", "128"}),
            "--address: value 128 is out of range; allowed: [0, 127]");
}

TEST(CommandLineTest, RefusesValuesThatDoNotFit) {
  EXPECT_EQ(usage_error({"run", "a", "--seed", "x"}), "--seed: expected a whole number, found 'x'");
  EXPECT_EQ(usage_error({"run", "a", "--seed", "1..x"}), "--seed: expected a whole number, found 'x'");
  EXPECT_EQ(usage_error({"detect", "--laser", "log:f", "--limit", "0"}),
            "--limit: value 0 is out of range; allowed: >= 1");
  EXPECT_EQ(usage_error({"run", "a", "--set", "x"}), "--set: expected PATH=VALUE, found 'x'");
  EXPECT_EQ(usage_error({"render", "a", "-o", "f", "--view", "tpo"}),
            "--view: unknown value 'tpo'; did you mean 'top'?");
  EXPECT_EQ(usage_error({"render", "a", "-o", "f", "--at", "soon"}), "--at: expected seconds, found 'soon'");
  for (const char* size : {"x", "640", "640x", "x480", "640x480x3", "-1x4", "9000x9000", "1e3x10"}) {
    EXPECT_TRUE(usage_error({"render", "a", "-o", "f", "--size", size}).starts_with("--size: ")) << size;
  }
  for (const char* size : {"63x480", "640x4097"}) {
    EXPECT_EQ(usage_error({"render", "a", "-o", "f", "--size", size}),
              "--size: expected WIDTHxHEIGHT, each of 64 to 4096 pixels, found '" + std::string(size) + "'");
  }
}

}  // namespace
}  // namespace scanbed::scenarios
