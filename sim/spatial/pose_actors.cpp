// SPDX-License-Identifier: MIT
#include "sim/spatial/pose_actors.hpp"

#include <cstddef>
#include <string>

#include "core/errors/ensure.hpp"
#include "sim/spatial/mjcf_actors.hpp"
#include "sim/spatial/part_names.hpp"
#include "sim/spatial/walker_body.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector2d;
using Eigen::Vector3d;

Isometry3d upright(const Pose2& X_WB) {
  Isometry3d X = Isometry3d::Identity();
  X.translation() << X_WB.p_m, 0.0;
  X.linear() = Eigen::AngleAxisd(X_WB.theta_rad, Vector3d::UnitZ()).toRotationMatrix();
  return X;
}

Isometry3d along(const Vector3d& p_WQ, const Vector3d& z_W) {
  Isometry3d X = Isometry3d::Identity();
  X.translation() = p_WQ;
  double q[4];  // w, x, y, z; Eigen's own way from one vector to another takes long to compile
  mju_quatZ2Vec(q, z_W.data());
  X.linear() = Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  return X;
}

Isometry3d absent() {
  return Isometry3d(Eigen::Translation3d(0.0, 0.0, kAbsent_m));
}

Vector3d lift(const Vector2d& p_WQ, double z_m) {
  return {p_WQ.x(), p_WQ.y(), z_m};
}

int body_of(const mjModel& model, const std::string& name) {
  const int id = mj_name2id(&model, mjOBJ_BODY, name.c_str());
  SCANBED_ENSURE(id >= 0);
  return id;
}

int mocap_of(const mjModel& model, const std::string& name) {
  const int mocap = model.body_mocapid[body_of(model, name)];
  SCANBED_ENSURE(mocap >= 0);
  return mocap;
}

int qpos_of(const mjModel& model, const std::string& name) {
  const int body = body_of(model, name);
  SCANBED_ENSURE(model.body_jntnum[body] > 0);
  return model.jnt_qposadr[model.body_jntadr[body]];
}

// A walker, or a tow, that the state does not name is not there.
template <typename State>
const State* present_of(const std::vector<State>& states, int walker) {
  for (const State& state : states) {
    if (state.present && state.walker == walker) return &state;
  }
  return nullptr;
}

}  // namespace

ActorPoser::ActorPoser(const World& world, const mjModel& model)
    : world_(world), model_(model), robot_(mocap_of(model, kRobotBody)) {
  int index = 0;
  for (const Walker& walker : world.walkers) {
    const auto part = [&](const char* name) { return mocap_of(model, walker_name(walker.id, name)); };
    people_.push_back({part("torso"),
                       {part("left_foot"), part("left_shank"), part("left_thigh")},
                       {part("right_foot"), part("right_shank"), part("right_thigh")}});
    if (walker.tow) {
      tows_.push_back({index, qpos_of(model, tow_name(walker.tow->id, "cylinder")),
                       qpos_of(model, tow_name(walker.tow->id, "walker_end")),
                       sim::rope_height_m(*walker.tow, walker)});
    }
    ++index;
  }
}

void ActorPoser::put_mocap(int mocap, const Isometry3d& X_WB, mjData& data) const {
  const Quaterniond q_WB(X_WB.linear());
  Eigen::Map<Vector3d>(data.mocap_pos + 3 * static_cast<std::ptrdiff_t>(mocap)) = X_WB.translation();
  Eigen::Map<Eigen::Vector4d>(data.mocap_quat + 4 * static_cast<std::ptrdiff_t>(mocap)) << q_WB.w(), q_WB.x(),
      q_WB.y(), q_WB.z();
}

// The shank goes from the foot through the point where the laser meets the leg, the thigh from there to the
// hip.
void ActorPoser::put_leg(const WalkerState& state, const Leg& leg, const LegPoints& points,
                         mjData& data) const {
  const WalkerBody body(world_.walkers[state.walker]);
  const Vector3d ankle_m = lift(points.foot_m, 0.0);
  const Vector3d hip_m = lift(state.X_WP * Vector2d(0.0, points.side * body.hip_offset_m), body.hip_m);
  const double laser_m = world_.robot.laser_height_m;
  const bool laser_meets_shank = laser_m > 0.05 && laser_m <= body.shank_m;
  const Vector3d through_m = laser_meets_shank ? lift(points.at_laser_m, laser_m) : hip_m;
  const Vector3d up = (through_m - ankle_m).normalized();
  const Vector3d knee_m = ankle_m + body.shank_m * up;
  put_mocap(leg.foot, upright({points.foot_m, state.X_WP.theta_rad}), data);
  put_mocap(leg.shank, along(ankle_m, up), data);
  put_mocap(leg.thigh, along(knee_m, hip_m - knee_m), data);
}

void ActorPoser::put_scripted(const WorldState& state, mjData& data) const {
  for (int i = 0; i < model_.nmocap; ++i) put_mocap(i, absent(), data);
  put_mocap(robot_, upright(state.X_WR), data);
  for (const WalkerState& walker : state.walkers) {
    SCANBED_ENSURE(walker.walker >= 0 && walker.walker < static_cast<int>(people_.size()));
    if (!walker.present) continue;
    const Person& person = people_[walker.walker];
    put_mocap(person.torso, upright(walker.X_WP), data);
    put_leg(walker, person.left, {walker.left_foot_m, walker.left_leg_m, 1.0}, data);
    put_leg(walker, person.right, {walker.right_foot_m, walker.right_leg_m, -1.0}, data);
  }
}

void ActorPoser::put_tow(int tow, const Vector3d& p_WB, mjData& data) const {
  Eigen::Map<Vector3d>(data.qpos + tows_[tow].cylinder_qpos) = p_WB;
}

void ActorPoser::put_rope_end(int tow, const Vector3d& p_WE, mjData& data) const {
  Eigen::Map<Vector3d>(data.qpos + tows_[tow].end_qpos) = p_WE;
}

void ActorPoser::put(const WorldState& state, mjData& data) const {
  put_scripted(state, data);
  for (int i = 0; i < static_cast<int>(tows_.size()); ++i) {
    const Pull& pull = tows_[i];
    const TowState* tow = present_of(state.tows, pull.walker);
    const WalkerState* walker = present_of(state.walkers, pull.walker);
    const Vector3d absent_m(0.0, 0.0, kAbsent_m);
    put_tow(i, tow != nullptr ? lift(tow->center_m, 0.0) : absent_m, data);
    // Without its walker, or without its cylinder, a rope lies rolled up where no one sees it.
    Vector3d end_m = absent_m;
    if (tow != nullptr) end_m = lift(tow->center_m, pull.rope_height_m);
    if (tow != nullptr && walker != nullptr) end_m = lift(walker->X_WP.p_m, pull.rope_height_m);
    put_rope_end(i, end_m, data);
  }
}

void pose_actors(const World& world, const WorldState& state, const mjModel& model, mjData& data) {
  ActorPoser(world, model).put(state, data);
  mj_kinematics(&model, &data);
  mj_comPos(&model, &data);
  mj_camlight(&model, &data);
  mj_tendon(&model, &data);
}

}  // namespace scanbed::sim
