// SPDX-License-Identifier: MIT
#include "scenarios/run/picture_taker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include "scenarios/run/output.hpp"

namespace scanbed::scenarios {
namespace {

// Scan times are sums of a period that has no exact binary form.
constexpr double kClockError_s = 1e-6;

}  // namespace

std::span<const std::string> view_names() {
  static const std::array<std::string, 3> kNames = {"top", "camera", "laser"};
  return kNames;
}

bool shows(const Scenario& scenario, const LaserScan& scan, double time_s) {
  const double moment_s = std::min(time_s, scenario.duration_s - 2.0 * kClockError_s);
  return moment_s < scan.time_s + scenario.lms.scan_period_s - kClockError_s;
}

std::string caption(const Scenario& scenario, const LaserScan& scan) {
  return fmt::format("{}  seed {}  t = {:.1f} s", scenario.name, scenario.seed, scan.time_s);
}

PictureTaker::PictureTaker(const Scenario& scenario, const sim::SimulatedLms& sensor,
                           std::filesystem::path folder)
    : scenario_(scenario), sensor_(sensor), folder_(std::move(folder)) {
  const PictureTimes& times = scenario.pictures;
  series_.push_back({sim::View::kTop, times.top_s, 0, nullptr});
  series_.push_back({sim::View::kCamera, times.camera_s, 0, nullptr});
  series_.push_back({sim::View::kLaser, times.laser_s, 0, nullptr});
}

PictureTaker::~PictureTaker() = default;

void PictureTaker::see(const LaserScan& scan, const Features& features) {
  for (Series& series : series_) {
    while (series.next < series.times_s.size() && shows(scenario_, scan, series.times_s[series.next])) {
      take(series, scan, features);
      ++series.next;
    }
  }
}

void PictureTaker::take(Series& series, const LaserScan& scan, const Features& features) {
  if (!series.painter) {
    series.painter =
        std::make_unique<sim::ScenePainter>(sensor_.world(), sim::PictureOptions{.view = series.view});
  }
  const std::string name =
      fmt::format("{}_{}_{:g}s.png", scenario_.name, view_names()[static_cast<std::size_t>(series.view)],
                  series.times_s[series.next]);
  const sim::Image image = series.painter->paint(sensor_.state(), {scan, features}, caption(scenario_, scan));
  write_whole(folder_ / name, sim::png_of(image));
  files_.push_back(folder_ / name);
}

}  // namespace scanbed::scenarios
