// SPDX-License-Identifier: MIT
#include "sim/spatial/pose_actors.hpp"

#include <Eigen/Geometry>
#include <cstddef>
#include <string>

#include "core/errors/ensure.hpp"
#include "sim/spatial/part_names.hpp"
#include "sim/spatial/walker_body.hpp"

namespace scanbed::sim {
namespace {

Eigen::Isometry3d upright(const Pose2& X_WB) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() << X_WB.p_m, 0.0;
  X.linear() = Eigen::AngleAxisd(X_WB.theta_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return X;
}

Eigen::Isometry3d along(const Eigen::Vector3d& p_WQ, const Eigen::Vector3d& z_W) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = p_WQ;
  X.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), z_W).toRotationMatrix();
  return X;
}

Eigen::Vector3d lift(const Eigen::Vector2d& p_WQ, double z_m) {
  return {p_WQ.x(), p_WQ.y(), z_m};
}

class Poser {
 public:
  Poser(const World& world, const mjModel& model, mjData& data) : world_(world), model_(model), data_(data) {}

  void put(const std::string& body, const Eigen::Isometry3d& X_WB) const {
    const int id = mj_name2id(&model_, mjOBJ_BODY, body.c_str());
    SCANBED_ENSURE(id >= 0 && model_.body_mocapid[id] >= 0);
    const int mocap = model_.body_mocapid[id];
    const Eigen::Quaterniond q_WB(X_WB.linear());
    Eigen::Map<Eigen::Vector3d>(mocap_pos(mocap)) = X_WB.translation();
    Eigen::Map<Eigen::Vector4d>(mocap_quat(mocap)) << q_WB.w(), q_WB.x(), q_WB.y(), q_WB.z();
  }

  void put_all_away() const {
    for (int i = 0; i < model_.nmocap; ++i) {
      Eigen::Map<Eigen::Vector3d>(mocap_pos(i)) = Eigen::Vector3d(0.0, 0.0, kAbsent_m);
      Eigen::Map<Eigen::Vector4d>(mocap_quat(i)) << 1.0, 0.0, 0.0, 0.0;
    }
  }

  void put_walker(const WalkerState& state) const {
    put(walker_name(walker(state.walker).id, "torso"), upright(state.X_WP));
    put_leg(state, Side::kLeft);
    put_leg(state, Side::kRight);
  }

  void put_tow(const TowState& state) const {
    const Tow& tow = *walker(state.walker).tow;
    put(tow_name(tow.id, "cylinder"), upright({state.center_m, 0.0}));
  }

  // The rope leaves the cylinder on the walker's side and ends at the small of the walker's back.
  void put_rope(const TowState& tow_state, const WalkerState& walker_state) const {
    const Walker& puller = walker(tow_state.walker);
    const Tow& tow = *puller.tow;
    const Eigen::Vector2d way_m = walker_state.X_WP.p_m - tow_state.center_m;
    const Eigen::Vector2d knot_m = tow_state.center_m + tow.radius_m * way_m.normalized();
    put(tow_name(tow.id, "cylinder_end"), along(lift(knot_m, 0.7 * tow.height_m), Eigen::Vector3d::UnitZ()));
    put(tow_name(tow.id, "walker_end"),
        along(lift(walker_state.X_WP.p_m, WalkerBody(puller).hip_m), Eigen::Vector3d::UnitZ()));
  }

 private:
  mjtNum* mocap_pos(std::ptrdiff_t mocap) const { return data_.mocap_pos + 3 * mocap; }
  mjtNum* mocap_quat(std::ptrdiff_t mocap) const { return data_.mocap_quat + 4 * mocap; }

  enum class Side { kLeft, kRight };

  const Walker& walker(int index) const {
    SCANBED_ENSURE(index >= 0 && index < static_cast<int>(world_.walkers.size()));
    return world_.walkers[index];
  }

  // The shank goes from the foot through the point where the laser meets the leg, the thigh from there to
  // the hip.
  void put_leg(const WalkerState& state, Side side) const {
    const bool left = side == Side::kLeft;
    const Walker& person = walker(state.walker);
    const WalkerBody body(person);
    const std::string prefix = left ? "left_" : "right_";
    const Eigen::Vector2d foot_m = left ? state.left_foot_m : state.right_foot_m;
    const Eigen::Vector3d ankle_m = lift(foot_m, 0.0);
    const Eigen::Vector3d hip_m =
        lift(state.X_WP * Eigen::Vector2d(0.0, left ? body.hip_offset_m : -body.hip_offset_m), body.hip_m);
    const double laser_m = world_.robot.laser_height_m;
    const bool laser_meets_shank = laser_m > 0.05 && laser_m <= body.shank_m;
    const Eigen::Vector3d through_m =
        laser_meets_shank ? lift(left ? state.left_leg_m : state.right_leg_m, laser_m) : hip_m;
    const Eigen::Vector3d up = (through_m - ankle_m).normalized();
    const Eigen::Vector3d knee_m = ankle_m + body.shank_m * up;
    put(walker_name(person.id, prefix + "foot"), upright({foot_m, state.X_WP.theta_rad}));
    put(walker_name(person.id, prefix + "shank"), along(ankle_m, up));
    put(walker_name(person.id, prefix + "thigh"), along(knee_m, hip_m - knee_m));
  }

  const World& world_;
  const mjModel& model_;
  mjData& data_;
};

const WalkerState* present_walker(const WorldState& state, int index) {
  for (const WalkerState& walker : state.walkers) {
    if (walker.present && walker.walker == index) return &walker;
  }
  return nullptr;
}

}  // namespace

void pose_actors(const World& world, const WorldState& state, const mjModel& model, mjData& data) {
  const Poser poser(world, model, data);
  poser.put_all_away();
  poser.put(kRobotBody, upright(state.X_WR));
  for (const WalkerState& walker : state.walkers) {
    if (walker.present) poser.put_walker(walker);
  }
  for (const TowState& tow : state.tows) {
    if (!tow.present) continue;
    poser.put_tow(tow);
    if (const WalkerState* walker = present_walker(state, tow.walker)) poser.put_rope(tow, *walker);
  }
  mj_kinematics(&model, &data);
  mj_comPos(&model, &data);
  mj_camlight(&model, &data);
  mj_tendon(&model, &data);
}

}  // namespace scanbed::sim
