// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/detect/features.hpp"
#include "core/scan/laser_scan.hpp"
#include "scenarios/load/scenario.hpp"
#include "sim/render/scene_picture.hpp"
#include "sim/sensor/simulated_lms.hpp"

namespace scanbed::scenarios {

/// "top", "camera" and "laser", in the order of View.
std::span<const std::string> view_names();

/// Whether a moment falls to this scan: to the last one that starts at or before it. The end of the scenario
/// falls to its last scan.
bool shows(const Scenario& scenario, const LaserScan& scan, double time_s);

/// One line about a scan, for the top of its picture.
std::string caption(const Scenario& scenario, const LaserScan& scan);

/// Paints the pictures that a scenario asks for while it runs.
class PictureTaker {
 public:
  /// @param sensor  the one that gives the scans; must outlive this.
  PictureTaker(const Scenario& scenario, const sim::SimulatedLms& sensor, std::filesystem::path folder);
  ~PictureTaker();

  /// Paints the pictures that fall to this scan. Builds the three-dimensional scene at the first.
  /// @throws InputError, SensorFault as ScenePainter does; OutputFault where a picture cannot be written.
  void see(const LaserScan& scan, const Features& features);

  /// Files written so far: "<folder>/<scenario>_<view>_<time>s.png".
  const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  // The pictures of one view, still to be taken from `next` on.
  struct Series {
    sim::View view;
    std::vector<double> times_s;
    std::size_t next = 0;
    std::unique_ptr<sim::ScenePainter> painter;
  };

  void take(Series& series, const LaserScan& scan, const Features& features);

  const Scenario& scenario_;
  const sim::SimulatedLms& sensor_;
  std::filesystem::path folder_;
  std::vector<Series> series_;
  std::vector<std::filesystem::path> files_;
};

}  // namespace scanbed::scenarios
