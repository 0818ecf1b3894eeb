// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/errors/input_error.hpp"
#include "hw/recording/open_recording.hpp"

namespace scanbed::hw {

/// A folder that goes away with its object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "scanbed_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// A scan of the LMS 200 in millimetres, with beams of every kind; `number` tells it from others.
inline LaserScan made_scan(int number) {
  LaserScan scan;
  scan.index = number;
  scan.time_s = 0.25 * number;
  scan.geometry.max_range_m = 8.183;
  for (int i = 0; i < scan.geometry.num_beams; ++i) {
    scan.range_m.push_back((1000 + (i * 37 + number * 11) % 7000) / 1000.0);
  }
  scan.range_m[1] = kNoEcho;
  scan.range_m[2] = kTooClose;
  scan.range_m[4] = kInvalid;
  scan.X_OR = Pose2{{1.25 + number, -0.5}, 0.125};
  return scan;
}

inline std::vector<LaserScan> made_scans(int num_scans) {
  std::vector<LaserScan> scans;
  for (int i = 0; i < num_scans; ++i) scans.push_back(made_scan(i));
  return scans;
}

inline Features made_features() {
  Features features;
  features.lines.push_back({.beams = {0, 40},
                            .left_m = {0.1, -3.0},
                            .right_m = {2.0, -3.0},
                            .slope = 1.0 / 3.0,
                            .bias_m = -3.0,
                            .num_points = 41,
                            .error_m = 0.004,
                            .score = 0.75,
                            .covariance = Eigen::Matrix2d{{1e-6, -1.0 / 3e7}, {-1.0 / 3e7, 2e-5}}});
  features.lines.push_back({.beams = {50, 60}, .num_points = 11});  // along y: no slope
  features.circles.push_back(
      {.beams = {120, 140}, .center_m = {3.0, 1.2}, .radius_m = 0.25, .average_rad = 1.9, .std_rad = 0.25});
  features.circles.push_back(
      {.beams = {150, 160},
       .center_m = {3.0, 2.0},
       .radius_m = 0.5,
       .covariance = Eigen::Matrix3d{{4e-6, 1e-7, 2e-6}, {1e-7, 5e-6, 0.0}, {2e-6, 0.0, 6e-6}}});
  features.legs.push_back({.beams = {200, 206}, .middle_m = {2.1, 0.4}, .score = 0.8});
  return features;
}

inline Truth made_truth(int num_beams) {
  Truth truth;
  truth.X_WS = {{1.0, 2.0}, 0.1};
  truth.objects.push_back({.id = "col_L",
                           .label = "column",
                           .primitive = Primitive::kCircle,
                           .center_m = {3.0, 1.2},
                           .radius_m = 0.25,
                           .num_clean_beams = 19,
                           .visibility = Visibility::kResolvable});
  truth.beams.resize(static_cast<std::size_t>(num_beams));
  for (BeamTruth& beam : truth.beams) beam.range_m = kNoEcho;
  truth.beams[3] = {.object = 0, .range_m = 2.0 / 3.0, .incidence_rad = 0.1, .mixed = true};
  return truth;
}

/// The bytes of a recording in the format that the name asks for.
inline std::string recorded(const std::string& name, const std::vector<LaserScan>& scans,
                            const RecordingMetadata& metadata = {}) {
  const TemporaryFolder folder;
  const auto writer = create_recording(folder / name, metadata);
  for (const LaserScan& scan : scans) writer->write({.scan = scan});
  writer->finish();
  return bytes_of(folder / name);
}

/// All that reading a recording to its end showed.
struct Reading {
  std::vector<LaserScan> scans;
  std::vector<std::optional<Features>> features;
  std::vector<std::optional<Truth>> truths;
  std::vector<std::string> reports;
  RecordingCounts counts;
  RecordingMetadata metadata;
  std::string error;  // of the InputError that ended it, if one did
};

inline void read_to_end(ScanReader& reader, Reading& reading) {
  for (LaserScan scan; reader.next(scan, {});) {
    reading.scans.push_back(scan);
    reading.features.push_back(reader.features() == nullptr ? std::nullopt
                                                            : std::optional(*reader.features()));
    reading.truths.push_back(reader.truth() == nullptr ? std::nullopt : std::optional(*reader.truth()));
  }
}

inline Reading read_all(std::string bytes, const std::string& name, const RecordingOptions& options = {}) {
  Reading reading;
  std::unique_ptr<ScanReader> reader;
  try {
    reader = open_recording(from_memory(std::move(bytes)), name, options,
                            [&](const std::string& message) { reading.reports.push_back(message); });
    read_to_end(*reader, reading);
  } catch (const InputError& error) {
    reading.error = error.what();
  }
  if (reader == nullptr) return reading;
  reading.counts = reader->counts();
  reading.metadata = reader->metadata();
  return reading;
}

/// Bit by bit, but that all NaN are alike.
inline bool same_ranges(const LaserScan& a, const LaserScan& b) {
  return std::equal(a.range_m.begin(), a.range_m.end(), b.range_m.begin(), b.range_m.end(),
                    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

}  // namespace scanbed::hw
