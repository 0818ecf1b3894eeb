// SPDX-License-Identifier: MIT
#include "sim/spatial/mjcf_solids.hpp"

#include <cmath>
#include <string>
#include <variant>

#include "sim/spatial/appearance.hpp"
#include "sim/spatial/mjcf_element.hpp"
#include "sim/spatial/part_names.hpp"

namespace scanbed::sim {
namespace {

class SolidWriter {
 public:
  SolidWriter(const Solid& solid, pugi::xml_node worldbody, pugi::xml_node asset)
      : solid_(solid), worldbody_(worldbody), asset_(asset) {}

  void operator()(const WallChain& chain) const {
    const int num_corners = static_cast<int>(chain.corners_m.size());
    const int num_walls = chain.closed ? num_corners : num_corners - 1;
    for (int n = 0; n < num_walls; ++n) {
      const double before_m = chain.closed || n > 0 ? 0.5 * kWallThickness_m : 0.0;
      const double after_m = chain.closed || n + 1 < num_walls ? 0.5 * kWallThickness_m : 0.0;
      const Eigen::Vector2d from_m = chain.corners_m[n];
      const Eigen::Vector2d to_m = chain.corners_m[(n + 1) % num_corners];
      const Eigen::Vector2d along = (to_m - from_m).normalized();
      add_wall(n, from_m - before_m * along, to_m + after_m * along);
      add_sheet(n, from_m, to_m);
    }
  }

  void operator()(const Cylinder& cylinder) const {
    geom(0, "cylinder", kSeenScripted)
        .set("pos", {cylinder.center_m.x(), cylinder.center_m.y(), mid_m()})
        .set("size", {cylinder.radius_m, half_height_m()});
  }

  void operator()(const Box& box) const {
    geom(0, "box", kSeenScripted)
        .set("pos", {box.X_WB.p_m.x(), box.X_WB.p_m.y(), mid_m()})
        .set("euler", {0.0, 0.0, box.X_WB.theta_rad})
        .set("size", {0.5 * box.size_m.x(), 0.5 * box.size_m.y(), half_height_m()});
  }

  void operator()(const Polygon& polygon) const {
    MjcfElement(asset_, "mesh")
        .set("name", solid_name(solid_.id, 0))
        .set("vertex", prism_vertices(polygon))
        .set("face", prism_faces(static_cast<int>(polygon.corners_m.size())));
    geom(0, "mesh", kSeenScripted).set("mesh", solid_name(solid_.id, 0));
  }

 private:
  double mid_m() const { return 0.5 * (solid_.bottom_m + solid_.top_m); }
  double half_height_m() const { return 0.5 * (solid_.top_m - solid_.bottom_m); }

  MjcfElement geom(int n, const char* type, const GeomRole& role) const {
    MjcfElement element(worldbody_, "geom");
    return element.set("name", solid_name(solid_.id, n))
        .set("type", type)
        .set_color(solid_color(solid_))
        .set_role(role);
  }

  void add_wall(int n, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const {
    MjcfElement wall = geom(n, "box", kPictureScripted);
    shape_wall(wall, from_m, to_m, kWallThickness_m);
  }

  void add_sheet(int n, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) const {
    MjcfElement wall(worldbody_, "geom");
    wall.set("name", sheet_name(solid_.id, n)).set("type", "box").set_role(kLaserOnly);
    shape_wall(wall, from_m, to_m, kSheetThickness_m);
  }

  void shape_wall(MjcfElement& wall, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m,
                  double thickness_m) const {
    const Eigen::Vector2d middle_m = 0.5 * (from_m + to_m);
    const Eigen::Vector2d along_m = to_m - from_m;
    wall.set("pos", {middle_m.x(), middle_m.y(), mid_m()})
        .set("euler", {0.0, 0.0, std::atan2(along_m.y(), along_m.x())})
        .set("size", {0.5 * along_m.norm(), 0.5 * thickness_m, half_height_m()});
  }

  // The outline at the bottom, then the outline at the top.
  std::string prism_vertices(const Polygon& polygon) const {
    std::string text;
    for (const double z_m : {solid_.bottom_m, solid_.top_m}) {
      for (const Eigen::Vector2d& p_WQ : polygon.corners_m)
        text += (text.empty() ? "" : " ") + mjcf_numbers({p_WQ.x(), p_WQ.y(), z_m});
    }
    return text;
  }

  // Two triangles a side, and a fan each for the two ends; all turn counter-clockwise seen from outside.
  static std::string prism_faces(int num_corners) {
    std::string text;
    const auto face = [&text](int a, int b, int c) {
      text +=
          (text.empty() ? "" : " ") + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c);
    };
    for (int i = 0; i < num_corners; ++i) {
      const int next = (i + 1) % num_corners;
      face(i, next, num_corners + next);
      face(i, num_corners + next, num_corners + i);
    }
    for (int i = 1; i + 1 < num_corners; ++i) {
      face(0, i + 1, i);
      face(num_corners, num_corners + i, num_corners + i + 1);
    }
    return text;
  }

  const Solid& solid_;
  pugi::xml_node worldbody_;
  pugi::xml_node asset_;
};

}  // namespace

void add_solid(const Solid& solid, pugi::xml_node worldbody, pugi::xml_node asset) {
  std::visit(SolidWriter(solid, worldbody, asset), solid.shape);
}

}  // namespace scanbed::sim
