// SPDX-License-Identifier: MIT
#include "sim/spatial/mujoco_model.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/errors/sensor_fault.hpp"

namespace scanbed::sim {
namespace {

constexpr const char* kBall =
    "<mujoco><worldbody><body><freejoint/><geom name='ball' size='0.1'/></body></worldbody></mujoco>";

std::string refusal(const std::string& mjcf) {
  try {
    load_model(mjcf);
  } catch (const SensorFault& fault) {
    EXPECT_EQ(fault.kind(), SensorFault::Kind::kSimulator);
    return fault.what();
  }
  return "";
}

TEST(MujocoModelTest, CompilesWhatIsGood) {
  const ModelPtr model = load_model(kBall);
  EXPECT_EQ(model->ngeom, 1);
  EXPECT_NEAR(model->geom_size[0], 0.1, 0.0);
  const DataPtr data = make_data(*model);
  mj_forward(model.get(), data.get());
  EXPECT_EQ(data->time, 0.0);
}

TEST(MujocoModelTest, SaysInOneLineWhatItRefuses) {
  for (const char* mjcf : {"", "no xml at all", "<mujoco>", "<mujoco><worldbody><geom/></worldbody></mujoco>",
                           "<mujoco><nonsense/></mujoco>"}) {
    const std::string message = refusal(mjcf);
    EXPECT_NE(message.find("MuJoCo refuses the world: "), std::string::npos) << mjcf;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_NE(refusal("<mujoco><nonsense/></mujoco>").find("nonsense"), std::string::npos);
}

TEST(MujocoModelTest, WarningsLeaveNoFileBehind) {
  const ModelPtr model = load_model(kBall);
  std::filesystem::remove("MUJOCO_LOG.TXT");
  ::testing::internal::CaptureStderr();
  mju_warning("a test's warning");
  EXPECT_NE(::testing::internal::GetCapturedStderr().find("MuJoCo: warning: a test's warning"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists("MUJOCO_LOG.TXT"));
}

TEST(MujocoModelDeathTest, ErrorsWithoutReturnAbortWithTheirMessage) {
  const ModelPtr model = load_model(kBall);
  EXPECT_DEATH(mju_error("nothing goes any more"), "MuJoCo: nothing goes any more");
}

}  // namespace
}  // namespace scanbed::sim
