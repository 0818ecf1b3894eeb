// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "sim/spatial/mujoco_model.hpp"
#include "tests/scenarios/run_program.hpp"

namespace scanbed::scenarios {
namespace {

using testing::Outcome;
using testing::run_program;

TEST(ExportTest, WritesAModelThatMuJoCoLoadsAndRuns) {
  const testing::TemporaryFolder folder;
  const std::string file = (folder / "hall.xml").string();
  const Outcome outcome = run_program({"export", "static_hallway", "--mjcf", file});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  const sim::ModelPtr model = sim::load_model(testing::read_file(file));
  EXPECT_GE(mj_name2id(model.get(), mjOBJ_GEOM, "solid/col_L/0"), 0);
  EXPECT_EQ(model->ntendon, 1);  // the rope of the towed cylinder
  const sim::DataPtr data = sim::make_data(*model);
  for (int i = 0; i < 10; ++i) mj_step(model.get(), data.get());
  EXPECT_EQ(data->warning[mjWARN_BADQACC].number, 0);
}

TEST(ExportTest, WritesToStandardOutputAndTakesSettings) {
  const Outcome plain = run_program({"export", "static_hallway", "--mjcf", "-"});
  const Outcome changed = run_program({"export", "static_hallway", "--mjcf", "-", "--set", "vars.R=0.3"});
  EXPECT_EQ(plain.out.substr(0, 5), "<?xml");
  EXPECT_EQ(changed.exit_code, 0) << changed.err;
  EXPECT_NE(plain.out, changed.out);
}

TEST(ExportTest, RefusesWhatItCannotDo) {
  EXPECT_EQ(run_program({"export", "static_hallway"}).exit_code, 2);
  EXPECT_EQ(run_program({"export", "no_such_scenario", "--mjcf", "-"}).exit_code, 2);
  EXPECT_EQ(run_program({"export", "static_hallway", "--mjcf", "/nowhere/hall.xml"}).exit_code, 3);
  const Outcome detector = run_program({"export", "static_hallway", "--mjcf", "-", "--set", "line_err=0.1"});
  EXPECT_EQ(detector.exit_code, 2);
  EXPECT_NE(detector.err.find("line_err"), std::string::npos) << detector.err;
}

TEST(ExportTest, TheSameScenarioRunsInBothEngines) {
  const Outcome planar = run_program({"run", "static_hallway"});
  const Outcome spatial = run_program({"run", "static_hallway", "--backend", "spatial"});
  EXPECT_NE(spatial.exit_code, 2) << spatial.err;
  EXPECT_NE(spatial.exit_code, 3) << spatial.err;
  EXPECT_EQ(planar.exit_code, spatial.exit_code);
  const Outcome unknown = run_program({"run", "static_hallway", "--backend", "spatail"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("did you mean 'spatial'?"), std::string::npos) << unknown.err;
}

}  // namespace
}  // namespace scanbed::scenarios
