// SPDX-License-Identifier: MIT
#pragma once

#include <pugixml.hpp>

#include "sim/world/world.hpp"

namespace scanbed::sim {

// Each adds mocap bodies at the origin; pose_actors puts them in their places.

/// Black body on wheels, and on it the laser as a blue cube about robot.X_RS at robot.laser_height_m.
void add_robot(const Robot& robot, pugi::xml_node worldbody);

/// Torso with head and arms, and on each side foot, shank and thigh. @param index  in World::walkers.
void add_walker(const Walker& walker, int index, pugi::xml_node worldbody);

/// The towed cylinder, and the rope as a tendon between two bodies of its own.
void add_tow(const Tow& tow, pugi::xml_node worldbody, pugi::xml_node tendon);

}  // namespace scanbed::sim
