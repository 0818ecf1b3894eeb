// SPDX-License-Identifier: MIT
#include "sim/planar/slice_objects.hpp"

#include "sim/world/solid_geometry.hpp"

namespace scanbed::sim {

SliceObjects::SliceObjects(const World& world) {
  const double laser_height_m = world.robot.laser_height_m;
  for (const Solid& solid : world.solids) {
    if (is_at_height(solid, laser_height_m)) add_solid(solid);
  }
  for (const Walker& walker : world.walkers) {
    left_leg_object_.push_back(laser_height_m <= walker.height_m ? add_legs(walker) : kNoObject);
  }
  for (const Walker& walker : world.walkers) {
    if (!walker.tow) continue;
    tow_object_.push_back(laser_height_m <= walker.tow->height_m ? add_tow(*walker.tow) : kNoObject);
  }
}

int SliceObjects::add_legs(const Walker& walker) {
  const auto left = static_cast<int>(objects_.size());
  for (const char* leg : {".left_leg", ".right_leg"}) {
    objects_.push_back({walker.id + leg, "leg", Primitive::kLeg, walker.leg_radius_m, walker.material});
  }
  return left;
}

int SliceObjects::add_tow(const Tow& tow) {
  objects_.push_back({tow.id, tow.label, Primitive::kCircle, tow.radius_m, tow.material});
  return static_cast<int>(objects_.size()) - 1;
}

void SliceObjects::add_solid(const Solid& solid) {
  if (const auto* cylinder = std::get_if<Cylinder>(&solid.shape)) {
    still_.discs.push_back({cylinder->center_m, cylinder->radius_m, static_cast<int>(objects_.size())});
    objects_.push_back({solid.id, solid.label, Primitive::kCircle, cylinder->radius_m, solid.material});
    return;
  }
  int count = 0;
  for (const Edge& edge : outline(solid.shape)) {
    still_.segments.push_back({edge.a_m, edge.b_m, static_cast<int>(objects_.size())});
    objects_.push_back(
        {solid.id + "." + std::to_string(count++), solid.label, Primitive::kLine, 0.0, solid.material});
  }
}

void SliceObjects::slice_at(const WorldState& state, PlanarSlice& slice) const {
  slice.segments.assign(still_.segments.begin(), still_.segments.end());
  slice.discs.assign(still_.discs.begin(), still_.discs.end());
  for (const WalkerState& walker : state.walkers) {
    const int left = left_leg_object_[walker.walker];
    if (!walker.present || left == kNoObject) continue;
    const double radius_m = objects_[left].radius_m;
    slice.discs.push_back({walker.left_leg_m, radius_m, left});
    slice.discs.push_back({walker.right_leg_m, radius_m, left + 1});
  }
  for (std::size_t i = 0; i < state.tows.size(); ++i) {
    const int object = tow_object_[i];
    if (!state.tows[i].present || object == kNoObject) continue;
    slice.discs.push_back({state.tows[i].center_m, objects_[object].radius_m, object});
  }
}

}  // namespace scanbed::sim
