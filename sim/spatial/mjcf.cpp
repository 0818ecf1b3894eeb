// SPDX-License-Identifier: MIT
#include "sim/spatial/mjcf.hpp"

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <sstream>

#include "sim/engine/physics_step.hpp"
#include "sim/spatial/appearance.hpp"
#include "sim/spatial/mjcf_actors.hpp"
#include "sim/spatial/mjcf_element.hpp"
#include "sim/spatial/mjcf_solids.hpp"
#include "sim/spatial/part_names.hpp"
#include "sim/spatial/world_bounds.hpp"

namespace scanbed::sim {
namespace {

// MuJoCo's defaults are made for a dark stage; here most of the light comes from everywhere, and one lamp
// draws the shadows.
void add_look(pugi::xml_node root, const Eigen::AlignedBox3d& bounds) {
  const Eigen::Vector3d center_m = bounds.center();
  MjcfElement(root, "statistic")
      .set("extent", {0.5 * bounds.diagonal().norm()})
      .set("center", {center_m.x(), center_m.y(), 0.0});
  const pugi::xml_node visual = MjcfElement(root, "visual").node();
  MjcfElement(visual, "headlight")
      .set("ambient", {0.57, 0.57, 0.59})
      .set("diffuse", {0.13, 0.13, 0.13})
      .set("specular", {0.0, 0.0, 0.0});
  MjcfElement(visual, "quality")
      .set("shadowsize", {2048})
      .set("offsamples", {4})
      .set("numslices", {20})
      .set("numstacks", {8});
  MjcfElement(visual, "map").set("shadowclip", {1.15}).set("shadowscale", {1.0});
}

void add_assets(pugi::xml_node asset) {
  const std::initializer_list<double> sky = {kSkyColor.x(), kSkyColor.y(), kSkyColor.z()};
  MjcfElement(asset, "texture")
      .set("name", "sky")
      .set("type", "skybox")
      .set("builtin", "flat")
      .set("rgb1", sky)
      .set("rgb2", sky)
      .set("width", {16})
      .set("height", {96});
  MjcfElement(asset, "texture")
      .set("name", "tiles")
      .set("type", "2d")
      .set("builtin", "checker")
      .set("rgb1", {0.93, 0.93, 0.92})
      .set("rgb2", {0.875, 0.88, 0.885})
      .set("width", {256})
      .set("height", {256});
}

// The sun shines over the robot's shoulder, so that what it lights is what the laser sees.
void add_sun(pugi::xml_node worldbody, const Eigen::AlignedBox3d& bounds, double robot_heading_rad) {
  constexpr double kAside_rad = radians(-12.0);
  const Eigen::Vector3d center_m = bounds.center();
  const Pose2 R_WL{Eigen::Vector2d::Zero(), robot_heading_rad + kAside_rad};
  const Eigen::Vector2d ahead = 0.45 * R_WL.heading();
  MjcfElement(worldbody, "light")
      .set("name", "sun")
      .set("directional", "true")
      .set("castshadow", "true")
      .set("pos", {center_m.x(), center_m.y(), 2.0 * bounds.max().z()})
      .set("dir", {ahead.x(), ahead.y(), -1.0})
      .set("ambient", {0.0, 0.0, 0.0})
      .set("diffuse", {0.38, 0.37, 0.35})
      .set("specular", {0.08, 0.08, 0.08});
}

// Even numbers of whole metres, so that a tile is one metre and tiles begin at whole coordinates.
void add_floor(pugi::xml_node asset, pugi::xml_node worldbody, const Eigen::AlignedBox3d& bounds) {
  constexpr double kMargin_m = 0.5;
  const double x0_m = std::floor(bounds.min().x() - kMargin_m);
  const double y0_m = std::floor(bounds.min().y() - kMargin_m);
  const double half_x_m = std::ceil(0.5 * (bounds.max().x() + kMargin_m - x0_m));
  const double half_y_m = std::ceil(0.5 * (bounds.max().y() + kMargin_m - y0_m));
  MjcfElement(asset, "material")
      .set("name", "floor")
      .set("texture", "tiles")
      .set("texrepeat", {half_x_m, half_y_m})
      .set("specular", {0.0})
      .set("reflectance", {0.0});
  MjcfElement(worldbody, "geom")
      .set("name", kFloorGeom)
      .set("type", "plane")
      .set("pos", {x0_m + half_x_m, y0_m + half_y_m, 0.0})
      .set("size", {half_x_m, half_y_m, 1.0})
      .set("material", "floor")
      .set_role(kPictureScripted);
  MjcfElement(worldbody, "geom")
      .set("name", kLaserFloorGeom)
      .set("type", "plane")
      .set("size", {0.0, 0.0, 1.0})  // without end
      .set_role(kLaserOnly);
}

void add_actors(const World& world, pugi::xml_node worldbody, pugi::xml_node tendon) {
  add_robot(world.robot, worldbody);
  for (int i = 0; i < static_cast<int>(world.walkers.size()); ++i) {
    add_walker(world.walkers[i], i, worldbody);
    if (world.walkers[i].tow) add_tow(*world.walkers[i].tow, world.walkers[i], worldbody, tendon);
  }
}

}  // namespace

std::string mjcf_of(const World& world) {
  const Eigen::AlignedBox3d bounds = world_bounds(world);
  pugi::xml_document document;
  const pugi::xml_node root = MjcfElement(document, "mujoco").set("model", "scanbed").node();
  MjcfElement(root, "compiler").set("angle", "radian");
  // The elliptic cone is the round one of Coulomb's law; a high ratio keeps what friction holds from
  // creeping.
  MjcfElement(root, "option")
      .set("timestep", {1.0 / kPhysicsSteps_per_s})
      .set("cone", "elliptic")
      .set("impratio", {10.0});
  // MuJoCo's own guess has room for some thirty cylinders, and drops what is too much. A contact takes three
  // rows, and memory grows with the square of their number.
  const auto num_tows =
      static_cast<double>(std::count_if(world.walkers.begin(), world.walkers.end(),
                                        [](const Walker& walker) { return walker.tow.has_value(); }));
  MjcfElement(root, "size").set("njmax", {500.0 + 60.0 * num_tows}).set("nconmax", {100.0 + 20.0 * num_tows});
  add_look(root, bounds);
  const pugi::xml_node asset = MjcfElement(root, "asset").node();
  const pugi::xml_node worldbody = MjcfElement(root, "worldbody").node();
  const pugi::xml_node tendon = MjcfElement(root, "tendon").node();
  add_assets(asset);
  add_sun(worldbody, bounds, world.robot.X_WR.theta_rad);
  add_floor(asset, worldbody, bounds);
  for (const Solid& solid : world.solids) add_solid(solid, worldbody, asset);
  add_actors(world, worldbody, tendon);
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace scanbed::sim
