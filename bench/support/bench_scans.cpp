// SPDX-License-Identifier: MIT
#include "bench/support/bench_scans.hpp"

#include <cstdio>
#include <filesystem>

#include "bench/support/hall_world.hpp"
#include "hw/recording/carmen_log.hpp"
#include "sim/sensor/simulated_lms.hpp"

namespace scanbed::bench {
namespace {

std::vector<LaserScan> all_scans(RangeSensor& sensor) {
  std::vector<LaserScan> scans;
  LaserScan scan;
  while (sensor.next(scan, RangeSensor::Seconds(0.0))) scans.push_back(scan);
  return scans;
}

}  // namespace

std::vector<BenchScans> bench_scans() {
  std::vector<BenchScans> sets;
  for (const char* name : {"columns_hall", "legs_pos1", "legs_pos2", "nobody"}) {
    const std::filesystem::path log =
        std::filesystem::path(SCANBED_SOURCE_DIR) / "../shared/data" / (std::string(name) + ".log");
    if (!std::filesystem::exists(log)) continue;
    hw::CarmenLog sensor(log, {},
                         [](const std::string& message) { std::fprintf(stderr, "%s\n", message.c_str()); });
    sets.push_back({name, all_scans(sensor)});
  }
  if (sets.empty()) {
    sim::SimulatedLms sensor(hall_world(), {.duration_s = 20.0, .seed = 1});
    sets.push_back({"simulated_hall", all_scans(sensor)});
  }
  return sets;
}

std::vector<LaserScan> hall_scans(int num_beams) {
  sim::SimulationOptions options{.duration_s = 4.0, .seed = 1};
  options.lms.step_rad = options.lms.fov_rad / (num_beams - 1);
  options.lms.interlace = false;
  sim::SimulatedLms sensor(hall_world(), options);
  return all_scans(sensor);
}

}  // namespace scanbed::bench
