// SPDX-License-Identifier: MIT
#include "sim/spatial/tow_physics.hpp"

#include <cstddef>
#include <string>

#include "core/errors/ensure.hpp"
#include "core/errors/sensor_fault.hpp"
#include "core/text/number_text.hpp"
#include "sim/spatial/mjcf_actors.hpp"
#include "sim/spatial/part_names.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector3d;

// High above everything: below the floor a body would be in contact with it.
constexpr double kAway_m = 1000.0;

int id_of(const mjModel& model, int type, const std::string& name) {
  const int id = mj_name2id(&model, type, name.c_str());
  SCANBED_ENSURE(id >= 0);
  return id;
}

Vector3d behind(const WalkerState& state, double distance_m) {
  const Eigen::Vector2d p_WB = state.X_WP * Eigen::Vector2d(-distance_m, 0.0);
  return {p_WB.x(), p_WB.y(), 0.0};
}

}  // namespace

TowPhysics::TowPhysics(const World& world, mjModel& model, const WorldState& start)
    : model_(model), data_(make_data(model)), poser_(world, model) {
  for (std::size_t i = 0; i < world.walkers.size(); ++i) {
    if (!world.walkers[i].tow) continue;
    const Tow& tow = *world.walkers[i].tow;
    const int cylinder = model.body_jntadr[id_of(model, mjOBJ_BODY, tow_name(tow.id, "cylinder"))];
    const int end = model.body_jntadr[id_of(model, mjOBJ_BODY, tow_name(tow.id, "walker_end"))];
    pulls_.push_back({static_cast<int>(i), id_of(model, mjOBJ_TENDON, tow_name(tow.id, "rope")),
                      model.jnt_qposadr[cylinder], model.jnt_dofadr[cylinder], model.jnt_dofadr[end],
                      tow.taut_m(), false, Vector3d::Zero()});
  }
  for (int i = 0; i < static_cast<int>(pulls_.size()); ++i) {
    const WalkerState& state = start.walkers[pulls_[i].walker];
    if (state.present) {
      appear(i, state);
    } else {
      stay_away(i);
    }
  }
}

void TowPhysics::appear(int tow, const WalkerState& state) {
  Pull& pull = pulls_[tow];
  pull.present = true;
  pull.end_m << state.X_WP.p_m, poser_.rope_height_m(tow);
  model_.tendon_limited[pull.tendon] = 1;
  poser_.put_tow(tow, behind(state, pull.taut_m), *data_);
  Eigen::Map<Vector3d>(data_->qvel + pull.cylinder_qvel).setZero();
}

// Held where it is, for it would fall.
void TowPhysics::stay_away(int tow) {
  Pull& pull = pulls_[tow];
  pull.present = false;
  model_.tendon_limited[pull.tendon] = 0;
  const Vector3d away_m(0.0, 0.0, kAway_m * (tow + 1));
  poser_.put_tow(tow, away_m, *data_);
  poser_.put_rope_end(tow, away_m, *data_);
  Eigen::Map<Vector3d>(data_->qvel + pull.cylinder_qvel).setZero();
  Eigen::Map<Vector3d>(data_->qvel + pull.end_qvel).setZero();
}

// The rope's end starts where it was and has the velocity that takes it to where it will be.
void TowPhysics::lead(int tow, const WalkerState& next) {
  Pull& pull = pulls_[tow];
  poser_.put_rope_end(tow, pull.end_m, *data_);
  const Vector3d to_m(next.X_WP.p_m.x(), next.X_WP.p_m.y(), pull.end_m.z());
  Eigen::Map<Vector3d>(data_->qvel + pull.end_qvel) = (to_m - pull.end_m) / kStep_s;
  pull.end_m = to_m;
}

void TowPhysics::step_to(const WorldState& next) {
  poser_.put_scripted(next, *data_);
  for (int i = 0; i < static_cast<int>(pulls_.size()); ++i) {
    const WalkerState& state = next.walkers[pulls_[i].walker];
    if (!state.present) {
      stay_away(i);
      continue;
    }
    if (!pulls_[i].present) appear(i, state);
    lead(i, state);
  }
  mj_step(&model_, data_.get());
  for (const int warning : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC}) {
    if (data_->warning[warning].number == 0) continue;
    throw SensorFault(SensorFault::Kind::kSimulator,
                      "MuJoCo: the towed cylinders' physics diverged at t = " + number_text(next.time_s) +
                          " s; a lighter cylinder or a slower walker may help");
  }
}

std::vector<Vector3d> TowPhysics::places() const {
  std::vector<Vector3d> places;
  for (const Pull& pull : pulls_) {
    places.emplace_back(Eigen::Map<const Vector3d>(data_->qpos + pull.cylinder_qpos));
  }
  return places;
}

}  // namespace scanbed::sim
