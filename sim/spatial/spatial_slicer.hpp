// SPDX-License-Identifier: MIT
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <vector>

#include "sim/planar/slice_objects.hpp"
#include "sim/spatial/plane_cut.hpp"
#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

/// Geoms of these groups are what the laser meets (see mjcf_of); mj_ray takes them as its geomgroup.
inline constexpr std::array<mjtByte, mjNGROUP> kLaserGroups{1, 0, 0, 1, 0, 0};

/// What a laser's plane, however tilted, cuts out of a MuJoCo model.
///
/// Objects count in the order of World::solids (the edges as outline() gives them, then "<id>.top", which is
/// top and underside), then of each walker left leg, right leg and "<id>.body", then each towed cylinder and
/// its "<id>.top", last "floor". Tops, bodies and the floor are no feature to a detector. The robot does not
/// see itself.
class SpatialSlicer {
 public:
  /// @pre the world validates, and the model comes from mjcf_of(world).
  SpatialSlicer(const World& world, const mjModel& model);

  const std::vector<SliceObject>& objects() const { return objects_; }

  /// Writes the slice, in the sensor frame, over `slice`. Geoms are where data has them (mj_kinematics);
  /// actors that `state` does not have are left out. Allocates nothing once it has seen all.
  void slice(const mjData& data, const LaserPlane& plane, const WorldState& state, PlanarSlice& slice);

 private:
  /// A geom that moves.
  struct Part {
    int geom = 0;
    int object = 0;
  };
  struct Standing {
    RoundBody body;
    CylinderObjects objects;
  };
  struct Pulled {
    int geom = 0;
    CylinderObjects objects;
  };

  int add_object(SliceObject object);
  void add_solid(const Solid& solid);
  void add_walker(const Walker& walker, const mjModel& model);
  void cut_part(const mjData& data, const LaserPlane& plane, const Part& part, PlanarSlice& slice) const;

  const mjModel& model_;
  std::vector<SliceObject> objects_;
  std::vector<Polyhedron> polyhedra_;
  std::vector<Standing> columns_;
  std::vector<std::vector<Part>> walkers_;
  std::vector<Pulled> tows_;
  int floor_ = 0;
  PlaneCutter cutter_;
};

}  // namespace scanbed::sim
