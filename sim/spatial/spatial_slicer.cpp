// SPDX-License-Identifier: MIT
#include "sim/spatial/spatial_slicer.hpp"

#include <cstddef>
#include <string>
#include <utility>

#include "core/errors/ensure.hpp"
#include "sim/spatial/part_names.hpp"
#include "sim/world/solid_geometry.hpp"

namespace scanbed::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Vector3d place_of(const mjData& data, int geom) {
  return Eigen::Map<const Vector3d>(data.geom_xpos + 3 * static_cast<std::ptrdiff_t>(geom));
}

Eigen::Matrix3d turn_of(const mjData& data, int geom) {
  return Eigen::Map<const RowMajor3>(data.geom_xmat + 9 * static_cast<std::ptrdiff_t>(geom));
}

Vector3d size_of(const mjModel& model, int geom) {
  return Eigen::Map<const Vector3d>(model.geom_size + 3 * static_cast<std::ptrdiff_t>(geom));
}

RoundBody round_body(const mjModel& model, const mjData& data, int geom) {
  const Vector3d size_m = size_of(model, geom);
  return {place_of(data, geom), turn_of(data, geom).col(2), size_m.x(), size_m.y()};
}

int body_id(const mjModel& model, const std::string& name) {
  const int id = mj_name2id(&model, mjOBJ_BODY, name.c_str());
  SCANBED_ENSURE(id >= 0);
  return id;
}

}  // namespace

SpatialSlicer::SpatialSlicer(const World& world, const mjModel& model) : model_(model) {
  for (const Solid& solid : world.solids) add_solid(solid);
  for (const Walker& walker : world.walkers) add_walker(walker, model);
  for (const Walker& walker : world.walkers) {
    if (!walker.tow) continue;
    const Tow& tow = *walker.tow;
    const int side = add_object({tow.id, tow.label, Primitive::kCircle, tow.radius_m, tow.material});
    const int top = add_object({tow.id + ".top", tow.label, Primitive::kNone, 0.0, tow.material});
    const int body = body_id(model, tow_name(tow.id, "cylinder"));
    tows_.push_back({model.body_geomadr[body], {side, top}});
  }
  floor_ = add_object({"floor", "floor", Primitive::kNone, 0.0, {}});
}

int SpatialSlicer::add_object(SliceObject object) {
  objects_.push_back(std::move(object));
  return static_cast<int>(objects_.size()) - 1;
}

void SpatialSlicer::add_solid(const Solid& solid) {
  if (const auto* cylinder = std::get_if<Cylinder>(&solid.shape)) {
    const int side =
        add_object({solid.id, solid.label, Primitive::kCircle, cylinder->radius_m, solid.material});
    const int top = add_object({solid.id + ".top", solid.label, Primitive::kNone, 0.0, solid.material});
    const double mid_m = 0.5 * (solid.bottom_m + solid.top_m);
    columns_.push_back({{{cylinder->center_m.x(), cylinder->center_m.y(), mid_m},
                         Vector3d::UnitZ(),
                         cylinder->radius_m,
                         0.5 * (solid.top_m - solid.bottom_m)},
                        {side, top}});
    return;
  }
  const bool is_filled = !std::holds_alternative<WallChain>(solid.shape);
  std::vector<Vector2d> corners_m;
  std::vector<int> objects;
  for (const Edge& edge : outline(solid.shape)) {
    const std::string id = solid.id + "." + std::to_string(objects.size());
    objects.push_back(add_object({id, solid.label, Primitive::kLine, 0.0, solid.material}));
    corners_m.push_back(edge.a_m);
    if (!is_filled) {
      polyhedra_.push_back(sheet({edge.a_m, edge.b_m}, solid.bottom_m, solid.top_m, objects.back()));
    }
  }
  objects.push_back(add_object({solid.id + ".top", solid.label, Primitive::kNone, 0.0, solid.material}));
  if (is_filled) polyhedra_.push_back(prism(corners_m, solid.bottom_m, solid.top_m, objects));
}

// Of each leg the shank comes last: where it is cut is where truth has the leg.
void SpatialSlicer::add_walker(const Walker& walker, const mjModel& model) {
  std::vector<Part>& parts = walkers_.emplace_back();
  const auto add_parts = [&](const std::string& part, int object) {
    const int body = body_id(model, walker_name(walker.id, part));
    for (int i = 0; i < model.body_geomnum[body]; ++i)
      parts.push_back({model.body_geomadr[body] + i, object});
  };
  const int left =
      add_object({walker.id + ".left_leg", "leg", Primitive::kLeg, walker.leg_radius_m, walker.material});
  const int right =
      add_object({walker.id + ".right_leg", "leg", Primitive::kLeg, walker.leg_radius_m, walker.material});
  add_parts("torso", add_object({walker.id + ".body", "body", Primitive::kNone, 0.0, walker.material}));
  for (const char* part : {"_foot", "_thigh", "_shank"}) {
    add_parts(std::string("left") + part, left);
    add_parts(std::string("right") + part, right);
  }
}

void SpatialSlicer::cut_part(const mjData& data, const LaserPlane& plane, const Part& part,
                             PlanarSlice& slice) const {
  const double away_m = plane.R_WS.col(2).dot(place_of(data, part.geom) - plane.p_WS);
  if (std::abs(away_m) > model_.geom_rbound[part.geom]) return;
  if (model_.geom_type[part.geom] == mjGEOM_ELLIPSOID) {
    cut_ellipsoid(plane, {place_of(data, part.geom), turn_of(data, part.geom), size_of(model_, part.geom)},
                  part.object, slice);
  } else {
    cut_capsule(plane, round_body(model_, data, part.geom), part.object, slice);
  }
}

void SpatialSlicer::slice(const mjData& data, const LaserPlane& plane, const WorldState& state,
                          PlanarSlice& slice) {
  slice.segments.clear();
  slice.discs.clear();
  slice.arcs.clear();
  for (const Polyhedron& body : polyhedra_) cutter_.cut(plane, body, slice);
  for (const Standing& column : columns_) cut_cylinder(plane, column.body, column.objects, slice);
  for (const WalkerState& walker : state.walkers) {
    if (!walker.present) continue;
    for (const Part& part : walkers_[walker.walker]) cut_part(data, plane, part, slice);
  }
  for (std::size_t i = 0; i < state.tows.size(); ++i) {
    if (!state.tows[i].present) continue;
    cut_cylinder(plane, round_body(model_, data, tows_[i].geom), tows_[i].objects, slice);
  }
  cut_floor(plane, floor_, slice);
}

}  // namespace scanbed::sim
