// SPDX-License-Identifier: MIT
#include "sim/spatial/pose_actors.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>

#include "sim/spatial/mjcf.hpp"
#include "sim/spatial/mujoco_model.hpp"
#include "sim/spatial/part_names.hpp"
#include "sim/spatial/walker_body.hpp"
#include "tests/support/hall.hpp"

namespace scanbed::sim {
namespace {

class PoseActorsTest : public ::testing::Test {
 protected:
  void pose() { pose_actors(world_, state_, *model_, *data_); }

  int body(const std::string& name) const {
    const int id = mj_name2id(model_.get(), mjOBJ_BODY, name.c_str());
    EXPECT_GE(id, 0) << name;
    return id;
  }
  Eigen::Vector3d origin(const std::string& name) const {
    return Eigen::Map<const Eigen::Vector3d>(data_->xpos + 3 * body(name));
  }
  Eigen::Vector3d axis(const std::string& name, int column) const {
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> R(data_->xmat + 9 * body(name));
    return R.col(column);
  }

  World world_ = test_hall();
  WorldState state_ = test_hall_state(world_);
  ModelPtr model_ = load_model(mjcf_of(world_));
  DataPtr data_ = make_data(*model_);
};

TEST_F(PoseActorsTest, TheRobotStandsAtItsPose) {
  state_.X_WR = {{1.5, -0.5}, 0.7};
  pose();
  EXPECT_LT((origin(kRobotBody) - Eigen::Vector3d(1.5, -0.5, 0.0)).norm(), 1e-12);
  EXPECT_LT((axis(kRobotBody, 0) - Eigen::Vector3d(std::cos(0.7), std::sin(0.7), 0.0)).norm(), 1e-12);
}

TEST_F(PoseActorsTest, TheLaserMeetsTheShankWhereTruthSaysTheLegIs) {
  pose();
  for (const bool left : {true, false}) {
    const std::string name = walker_name("student_A", left ? "left_shank" : "right_shank");
    const Eigen::Vector3d up = axis(name, 2);
    const Eigen::Vector3d at = origin(name) + world_.robot.laser_height_m / up.z() * up;
    const WalkerState& walker = state_.walkers[0];
    EXPECT_LT((at.head<2>() - (left ? walker.left_leg_m : walker.right_leg_m)).norm(), 1e-12);
    EXPECT_NEAR(origin(name).z(), 0.0, 1e-12);
  }
}

TEST_F(PoseActorsTest, TheThighPointsFromTheKneeToTheHip) {
  pose();
  const WalkerBody body(world_.walkers[0]);
  const Eigen::Vector3d knee_m = origin(walker_name("student_A", "left_shank")) +
                                 body.shank_m * axis(walker_name("student_A", "left_shank"), 2);
  const std::string thigh = walker_name("student_A", "left_thigh");
  EXPECT_LT((origin(thigh) - knee_m).norm(), 1e-12);
  // Pelvis at (0.9, 2.8), walking along x: the left hip is on the side of +y.
  const Eigen::Vector3d hip_m(0.9, 2.8 + body.hip_offset_m, body.hip_m);
  EXPECT_LT((axis(thigh, 2) - (hip_m - knee_m).normalized()).norm(), 1e-9);
}

TEST_F(PoseActorsTest, ALaserAboveTheKneesLeavesTheLegsStraight) {
  world_.robot.laser_height_m = 1.2;
  pose();
  const WalkerBody body(world_.walkers[0]);
  const Eigen::Vector3d foot_m(state_.walkers[0].left_foot_m.x(), state_.walkers[0].left_foot_m.y(), 0.0);
  const Eigen::Vector3d hip_m(0.9, 2.8 + body.hip_offset_m, body.hip_m);
  EXPECT_LT((axis(walker_name("student_A", "left_shank"), 2) - (hip_m - foot_m).normalized()).norm(), 1e-9);
}

TEST_F(PoseActorsTest, TheRopeSpansLevelFromTheCylindersAxisToThePelvis) {
  pose();
  EXPECT_LT((origin(tow_name("cyl", "cylinder")) - Eigen::Vector3d(-0.25, 2.8, 0.0)).norm(), 1e-12);
  EXPECT_NEAR(data_->ten_length[0], 0.25 + 0.9, 1e-9);  // pelvis at (0.9, 2.8)
}

TEST_F(PoseActorsTest, TheAbsentAreOutOfSight) {
  state_.walkers[1].present = false;
  state_.tows[0].present = false;
  pose();
  EXPECT_EQ(origin(walker_name("student_B", "torso")).z(), kAbsent_m);
  EXPECT_EQ(origin(tow_name("cyl", "cylinder")).z(), kAbsent_m);
  EXPECT_EQ(origin(tow_name("cyl", "walker_end")).z(), kAbsent_m);
  EXPECT_EQ(origin(walker_name("student_A", "torso")).z(), 0.0);
}

TEST_F(PoseActorsTest, WhoComesBackStandsWhereTheStateSays) {
  state_.walkers.clear();
  state_.tows.clear();
  pose();
  EXPECT_EQ(origin(walker_name("student_A", "torso")).z(), kAbsent_m);
  state_ = test_hall_state(world_);
  pose();
  EXPECT_LT((origin(walker_name("student_A", "torso")) - Eigen::Vector3d(0.9, 2.8, 0.0)).norm(), 1e-12);
}

TEST_F(PoseActorsTest, ACylinderWithoutItsWalkerHasNoRope) {
  state_.walkers[0].present = false;
  pose();
  EXPECT_EQ(origin(tow_name("cyl", "cylinder")).z(), 0.0);
  EXPECT_NEAR(data_->ten_length[0], 0.0, 1e-9);
}

}  // namespace
}  // namespace scanbed::sim
