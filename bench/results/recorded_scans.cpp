// SPDX-License-Identifier: MIT
#include "bench/results/recorded_scans.hpp"

#include <cstdio>
#include <string>

#include "hw/recording/carmen_log.hpp"

namespace scanbed::bench {

int for_each_scan(const std::filesystem::path& log, const std::function<void(const LaserScan&)>& use) {
  hw::CarmenLog sensor(log, {},
                       [](const std::string& message) { std::fprintf(stderr, "%s\n", message.c_str()); });
  LaserScan scan;
  int num_scans = 0;
  for (; sensor.next(scan, RangeSensor::Seconds(0.0)); ++num_scans) use(scan);
  return num_scans;
}

}  // namespace scanbed::bench
