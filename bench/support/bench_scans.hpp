// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/scan/laser_scan.hpp"

namespace scanbed::bench {

/// Scans to measure on, and where they came from.
struct BenchScans {
  std::string name;
  std::vector<LaserScan> scans;
};

/// The recordings beside the project, or where they are not there one set of scans simulated in a hall.
std::vector<BenchScans> bench_scans();

/// A simulated hall, seen by a laser of 180 degrees with so many beams.
std::vector<LaserScan> hall_scans(int num_beams);

}  // namespace scanbed::bench
