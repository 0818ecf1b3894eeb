// SPDX-License-Identifier: MIT
#pragma once

#include "scenarios/load/scenario.hpp"
#include "scenarios/load/value.hpp"

namespace scanbed::scenarios {

// The sections of a scenario file, each read by a file of its own (load_sensor.cpp, ...). All throw
// InputError with the place of the first value that does not fit.

/// `sensor:`; sets the LMS's options and the robot's laser height.
void load_sensor(const Value& value, Scenario& scenario);

/// `robot:`; sets the world's robot, except for the laser's height.
void load_robot(const Value& value, sim::Robot& robot);

/// `world:`, a list of solids; adds them.
void load_solids(const Value& value, std::vector<sim::Solid>& solids);

/// `actors:`, a list of walkers; adds them.
void load_actors(const Value& value, std::vector<sim::Walker>& walkers);

/// `score:`; sets when a detection counts as right, and the needs.
void load_score(const Value& value, Scenario& scenario);

}  // namespace scanbed::scenarios
