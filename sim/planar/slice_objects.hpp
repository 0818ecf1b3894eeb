// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/scan/truth.hpp"
#include "sim/planar/planar_slice.hpp"
#include "sim/world/world.hpp"
#include "sim/world/world_state.hpp"

namespace scanbed::sim {

/// One thing that the laser's plane can meet: a wall, an edge of a box, a column, a leg, a towed cylinder.
struct SliceObject {
  std::string id;
  std::string label;
  Primitive primitive = Primitive::kNone;
  double radius_m = 0.0;  ///< of round things
  Material material;
};

/// The objects of a world in the laser's plane, and the slice at any of its states.
///
/// Each object is one segment or one disc. They count in the order of World::solids (edges as outline()
/// gives them), then left and right leg of each walker, then the towed cylinders; only what reaches up to the
/// laser. Between hips and head a walker still has two legs.
class SliceObjects {
 public:
  /// @pre the world validates.
  explicit SliceObjects(const World& world);

  const std::vector<SliceObject>& objects() const { return objects_; }

  /// Writes the slice at `state` over `slice`; only what is present. Allocates nothing once it has seen all.
  void slice_at(const WorldState& state, PlanarSlice& slice) const;

 private:
  void add_solid(const Solid& solid);
  int add_legs(const Walker& walker);  ///< its left leg's object
  int add_tow(const Tow& tow);         ///< its object

  std::vector<SliceObject> objects_;
  PlanarSlice still_;
  // kNoObject where the laser passes above.
  std::vector<int> left_leg_object_;  ///< of each walker; its right leg follows
  std::vector<int> tow_object_;       ///< of each tow
};

}  // namespace scanbed::sim
