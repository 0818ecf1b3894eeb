// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/score/scorer.hpp"
#include "scenarios/load/expect.hpp"
#include "scenarios/load/need.hpp"
#include "sim/sensor/lms_options.hpp"
#include "sim/world/world.hpp"

namespace scanbed::scenarios {

/// Times at which a run paints the scene, one list a view; rising.
struct PictureTimes {
  std::vector<double> top_s;
  std::vector<double> camera_s;
  std::vector<double> laser_s;
};

/// One scripted scenario: a world, the laser in it, and what its detections must reach.
struct Scenario {
  std::string name;
  std::string description;
  std::uint64_t seed = 1;
  double duration_s = 10.0;
  sim::World world;
  sim::LmsOptions lms;
  MatchOptions match;
  std::vector<Need> needs;                ///< in the order of the file
  std::vector<Expectation> expectations;  ///< in the order of the file
  PictureTimes pictures;
  std::optional<std::string> known_fail;  ///< why its needs are not met yet; a miss is then reported only
};

}  // namespace scanbed::scenarios
