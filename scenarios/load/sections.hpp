// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "scenarios/load/scenario.hpp"
#include "scenarios/load/table.hpp"
#include "scenarios/load/value.hpp"

namespace scanbed::scenarios {

// The sections of a scenario file, each read by a file of its own (load_sensor.cpp, ...). All throw
// InputError with the place of the first value that does not fit.

/// `sensor:`; sets the sensor's options, and height, pitch and roll of the robot's laser.
void load_sensor(const Value& value, Scenario& scenario);

/// `generate:`, the kind of world that is drawn from the seed; sets the world but for what `sensor:` says of
/// its laser. @pre  seed and sensor are known.
void load_generated(const Value& value, Scenario& scenario);

/// `robot:`; sets the world's robot, except for what `sensor:` says of its laser.
void load_robot(const Value& value, sim::Robot& robot);

/// `world:`, a list of solids; adds them.
void load_solids(const Value& value, std::vector<sim::Solid>& solids);

/// `map:`, the YAML file of a map as map_server reads it; adds the outlines of what is occupied as walls.
///
/// @param frame  what the walls have in common; their ids are "<its id>.0" and so on.
void load_map(const Value& value, const sim::Solid& frame, std::vector<sim::Solid>& solids);

/// `actors:`, a list of walkers; adds them. @pre  seed and laser height are known: bodies depend on them.
void load_actors(const Value& value, Scenario& scenario);

/// `material:`, the name of a material or a map that may change it.
sim::Material load_material(const Value& value);

/// `score:`; sets when a detection counts as right, and the needs.
void load_score(const Value& value, Scenario& scenario);

/// `between:`, [from, to] within the run.
TimeWindow load_window(const Value& value, double duration_s);

/// `preset:`, the detectors that a need or an expectation is of; empty where the key is not there.
std::optional<std::string> take_preset(Table& table);

/// `known_fail:`, why something is not met yet.
std::optional<std::string> take_known_fail(Table& table);

/// `expect:`, a list of conditions over time; adds them. @pre  the world is loaded: they name its objects.
void load_expect(const Value& value, Scenario& scenario);

}  // namespace scanbed::scenarios
