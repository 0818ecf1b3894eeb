// SPDX-License-Identifier: MIT
#pragma once

#include <pugixml.hpp>

#include "sim/world/world.hpp"

namespace scanbed::sim {

// Each adds bodies at the origin; pose_actors puts them in their places. What follows the script is a mocap
// body.

/// Black body on wheels, and on it the laser as a blue cube about robot.X_RS at robot.laser_height_m.
void add_robot(const Robot& robot, pugi::xml_node worldbody);

/// Torso with head and arms, and on each side foot, shank and thigh. @param index  in World::walkers.
void add_walker(const Walker& walker, int index, pugi::xml_node worldbody);

/// The towed cylinder as a free body, and the rope as a tendon, limited to its length, from the cylinder's
/// axis to a heavy body of its own that moves along with the walker. (A mocap body would do, but for its
/// velocity, which MuJoCo takes for 0: the rope would give way by some centimetres.)
void add_tow(const Tow& tow, const Walker& walker, pugi::xml_node worldbody, pugi::xml_node tendon);

/// Above the floor, of both ends of the rope: on the cylinder, and within reach of the walker's hands.
double rope_height_m(const Tow& tow, const Walker& walker);

}  // namespace scanbed::sim
