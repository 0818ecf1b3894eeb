// SPDX-License-Identifier: MIT
// Any scan gives features that lie on it: beams in range and in order, numbers that are finite.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "core/detect/feature_detector.hpp"
#include "core/errors/ensure.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace {

using scanbed::LaserScan;

/// Two bytes a beam: 13 bits of millimetre steps as from the sensor, the codes above them without echo. One
/// byte in front chooses the geometry.
LaserScan scan_of(const std::uint8_t* data, std::size_t size) {
  LaserScan scan;
  if (size == 0) return scan;
  constexpr double kStepsDeg[] = {0.5, 0.25, 1.0, -0.5, 2.0, 0.0, 1e-6, 30.0};
  scan.geometry.step_rad = scanbed::radians(kStepsDeg[data[0] % 8]);
  for (std::size_t i = 1; i + 1 < size; i += 2) {
    const int word = data[i] | (data[i + 1] << 8);
    if (word % 8192 < 8183) {
      // The highest bits choose how fine the steps are: coincident points, ordinary ones, and far ones.
      constexpr double kUnits_m[] = {0.001, 0.01, 1e-9, 0.0, 1.0, 1e6, 1e150, 1e300};
      scan.range_m.push_back((word % 8192) * kUnits_m[word / 8192]);
    } else {
      constexpr double kNone_m[] = {scanbed::kNoEcho, scanbed::kTooClose, scanbed::kInvalid};
      scan.range_m.push_back(kNone_m[word % 3]);
    }
  }
  scan.geometry.num_beams = scan.num_beams();
  return scan;
}

void check_beams(const scanbed::BeamSpan& beams, const LaserScan& scan) {
  SCANBED_ENSURE(0 <= beams.first && beams.first <= beams.last && beams.last < scan.num_beams());
  SCANBED_ENSURE(scan.has_echo(beams.first) && scan.has_echo(beams.last));
}

void check_score(double score) {
  SCANBED_ENSURE(score >= 0.0 && score <= 1.0);
}

/// Ranges that no sensor has may overflow; below that every number must be finite.
bool is_sane(const LaserScan& scan) {
  return std::none_of(scan.range_m.begin(), scan.range_m.end(),
                      [](double range_m) { return std::isfinite(range_m) && range_m > 1e7; });
}

void check_numbers(const scanbed::Features& features) {
  for (const auto& line : features.lines) {
    SCANBED_ENSURE(line.left_m.allFinite() && line.right_m.allFinite() && std::isfinite(line.error_m));
    SCANBED_ENSURE(line.slope.has_value() == line.bias_m.has_value());
    check_score(line.score);
  }
  for (const auto& circle : features.circles) {
    SCANBED_ENSURE(circle.center_m.allFinite() && std::isfinite(circle.radius_m) && circle.radius_m >= 0.0);
    check_score(circle.score);
  }
  for (const auto& leg : features.legs) {
    SCANBED_ENSURE(leg.middle_m.allFinite());
    check_score(leg.score);
  }
}

template <class List>
void check_order(const List& list, const LaserScan& scan) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    check_beams(list[i].beams, scan);
    SCANBED_ENSURE(i == 0 || list[i - 1].beams.first <= list[i].beams.first);
  }
}

scanbed::DetectorOptions by_inscribed_angles() {
  scanbed::DetectorOptions options = scanbed::paper_options();
  options.line.method = scanbed::LineMethod::kInscribedAngle;
  options.circle.prerequisite = false;
  options.circle.in_lines = true;
  return options;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static scanbed::FeatureDetector detectors[] = {scanbed::FeatureDetector(scanbed::paper_options()),
                                                 scanbed::FeatureDetector(by_inscribed_angles())};
  const LaserScan scan = scan_of(data, size);
  for (scanbed::FeatureDetector& detector : detectors) {
    const scanbed::Features& features = detector.detect(scan);
    check_order(features.lines, scan);
    check_order(features.circles, scan);
    check_order(features.legs, scan);
    if (is_sane(scan)) check_numbers(features);
  }
  return 0;
}
