// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/options/option_table.hpp"
#include "tests/scenarios/run_program.hpp"

namespace scanbed::scenarios {
namespace {

using testing::Outcome;
using testing::run_program;

TEST(OptionsCommandTest, PrintsThePresetWithUnitsEffectsAndTableTwosNames) {
  const Outcome outcome = run_program({"options", "--preset", "robust"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.out.find("pipeline: robust"), std::string::npos);
  EXPECT_NE(outcome.out.find("track:\n  motion: auto"), std::string::npos);
  EXPECT_NE(outcome.out.find("(Table II: line_min_len, mm)"), std::string::npos);
  EXPECT_NE(outcome.out.find("# [m/s]"), std::string::npos);
  EXPECT_EQ(outcome.out.find("max_std_rad"), std::string::npos);  // the paper's alone
  EXPECT_NE(run_program({"options", "--preset", "paper"}).out.find("max_std_rad: 0.15"), std::string::npos);
}

TEST(OptionsCommandTest, ReadsWhatItPrints) {
  const testing::TemporaryFolder folder;
  for (const std::string preset : {"paper", "robust"}) {
    const Outcome printed = run_program({"options", "--preset", preset, "--set", "track.gate_m=0.2"});
    const auto file = testing::write_file(folder / (preset + ".yaml"), printed.out);
    const Outcome again = run_program({"options", "--preset", preset, "--config", file.string()});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(again.out, printed.out);
    EXPECT_NE(again.out.find("gate_m: 0.2"), std::string::npos);
  }
}

TEST(OptionsCommandTest, NamesThePresetWhosePipelineRuns) {
  const testing::TemporaryFolder folder;
  const Outcome paper = run_program({"options", "--preset", "paper"});
  const auto file = testing::write_file(folder / "paper.yaml", paper.out);
  EXPECT_EQ(run_program({"options", "--config", file.string()}).out, paper.out);
  EXPECT_EQ(run_program({"options", "--set", "pipeline=paper"}).out, paper.out);
  EXPECT_EQ(run_program({"options", "--preset", "paper", "--set", "pipeline=robust"}).exit_code, 2);
}

TEST(OptionsCommandTest, RefusesWhatIsNone) {
  EXPECT_EQ(run_program({"options", "--preset", "robst"}).exit_code, 2);
  const Outcome typo = run_program({"options", "--set", "track.gaet_m=0.2"});
  EXPECT_EQ(typo.exit_code, 2);
  EXPECT_NE(typo.err.find("did you mean 'gate_m'?"), std::string::npos) << typo.err;
  const Outcome other = run_program({"options", "--set", "sensor.noise.sigma=0.2"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("no such option"), std::string::npos) << other.err;
}

}  // namespace
}  // namespace scanbed::scenarios
