// SPDX-License-Identifier: MIT
#include "bench/results/recorded_results.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "bench/results/recorded_scans.hpp"
#include "core/detect/feature_detector.hpp"
#include "core/geometry/angles.hpp"

namespace scanbed::bench {
namespace {

using Places = std::vector<Eigen::Vector2d>;

constexpr double kCircleGate_m = 0.10;
constexpr double kMaybeGate_m = 0.35;
constexpr int kMinColumnBeams = 8;
constexpr double kMinColumnRadius_m = 0.2;
constexpr double kMaxColumnRadius_m = 0.5;
constexpr double kLegRange_m = 5.0;

// Distances of the pairs that a one-to-one matching, nearest first, makes within the gate.
std::vector<double> matched_distances_m(const Places& labels, const Places& found, double gate_m) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t k = 0; k < found.size(); ++k) {
      const double distance_m = (labels[i] - found[k]).norm();
      if (distance_m <= gate_m) pairs.emplace_back(distance_m, i, k);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<bool> label_taken(labels.size(), false);
  std::vector<bool> found_taken(found.size(), false);
  std::vector<double> distances_m;
  for (const auto& [distance_m, i, k] : pairs) {
    if (label_taken[i] || found_taken[k]) continue;
    label_taken[i] = found_taken[k] = true;
    distances_m.push_back(distance_m);
  }
  return distances_m;
}

bool is_near_any(const Eigen::Vector2d& p_m, const Places& places, double gate_m) {
  return std::any_of(places.begin(), places.end(),
                     [&](const auto& q_m) { return (p_m - q_m).norm() <= gate_m; });
}

const Places& places_of(const Labels& labels, int scan) {
  static const Places kNone;
  const auto it = labels.find(scan);
  return it == labels.end() ? kNone : it->second;
}

// So far within the labelled sector that a label within the gate would be in it too.
bool would_be_labelled(const Eigen::Vector2d& p_m) {
  const double distance_m = p_m.norm();
  if (distance_m <= kLegGate_m || distance_m > kLegRange_m - kLegGate_m) return false;
  return std::abs(std::atan2(p_m.y(), p_m.x())) + std::asin(kLegGate_m / distance_m) <= radians(15.0);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

bool looks_like_a_column(const Circle& circle) {
  return circle.beams.last - circle.beams.first + 1 >= kMinColumnBeams &&
         circle.radius_m > kMinColumnRadius_m && circle.radius_m < kMaxColumnRadius_m;
}

}  // namespace

CircleResult circles_in_recording(const std::filesystem::path& log, const Labels& labels, const Labels& maybe,
                                  const DetectorOptions& options) {
  FeatureDetector detector(options);
  CircleResult result;
  std::vector<double> errors_m;
  result.num_scans = for_each_scan(log, [&](const LaserScan& scan) {
    const int number = static_cast<int>(scan.index);
    const Places& arcs = places_of(labels, number);
    Places centers;
    for (const Circle& circle : detector.detect(scan).circles) {
      centers.push_back(circle.center_m);
      const bool known = is_near_any(circle.center_m, arcs, kMaybeGate_m) ||
                         is_near_any(circle.center_m, places_of(maybe, number), kMaybeGate_m);
      if (looks_like_a_column(circle) && !known) ++result.num_unmatched;
    }
    const std::vector<double> distances_m = matched_distances_m(arcs, centers, kCircleGate_m);
    errors_m.insert(errors_m.end(), distances_m.begin(), distances_m.end());
    result.num_labels += static_cast<int>(arcs.size());
  });
  result.num_found = static_cast<int>(errors_m.size());
  result.median_error_m = median(errors_m);
  return result;
}

ScoreBins binned_legs(const std::filesystem::path& log, const Labels& labels, const LegForest& forest) {
  FeatureDetector detector(robust_options(), forest);
  ScoreBins bins;
  for_each_scan(log, [&](const LaserScan& scan) {
    const Places& legs = places_of(labels, static_cast<int>(scan.index));
    for (const Leg& leg : detector.detect(scan).legs) {
      if (would_be_labelled(leg.middle_m)) bins.add(leg.score, is_near_any(leg.middle_m, legs, kLegGate_m));
    }
  });
  return bins;
}

std::vector<ScoredLeg> scored_legs(const std::filesystem::path& log, const DetectorOptions& options,
                                   const LegForest& forest) {
  FeatureDetector detector(options, forest);
  std::vector<ScoredLeg> legs;
  for_each_scan(log, [&](const LaserScan& scan) {
    for (const Leg& leg : detector.detect(scan).legs) {
      if (leg.middle_m.norm() <= kLegRange_m) legs.push_back({static_cast<int>(scan.index), leg.score});
    }
  });
  return legs;
}

LegResult legs_in_recording(const std::filesystem::path& log, const Labels& labels,
                            const DetectorOptions& options, const LegForest& forest) {
  FeatureDetector detector(options, forest);
  LegResult result;
  result.num_scans = for_each_scan(log, [&](const LaserScan& scan) {
    Places middles;
    for (const Leg& leg : detector.detect(scan).legs) {
      middles.push_back(leg.middle_m);
      if (leg.middle_m.norm() <= kLegRange_m) ++result.num_detections;
    }
    const Places& legs = places_of(labels, static_cast<int>(scan.index));
    result.num_labels += static_cast<int>(legs.size());
    result.num_found += static_cast<int>(matched_distances_m(legs, middles, kLegGate_m).size());
  });
  return result;
}

}  // namespace scanbed::bench
