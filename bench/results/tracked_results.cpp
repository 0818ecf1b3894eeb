// SPDX-License-Identifier: MIT
#include "bench/results/tracked_results.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include "bench/results/labels.hpp"
#include "bench/results/recorded_scans.hpp"
#include "core/detect/feature_detector.hpp"
#include "core/track/tracker.hpp"

namespace scanbed::bench {
namespace {

constexpr double kPersonGate_m = 0.40;

int legs_of(const Track& track) {
  return track.kind == TrackKind::kPerson ? 2 : track.kind == TrackKind::kLeg ? 1 : 0;
}

int num_found(const std::vector<Eigen::Vector2d>& labels, const std::vector<Track>& tracks) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t k = 0; k < tracks.size(); ++k) {
      const double distance_m = (labels[i] - tracks[k].position_m).norm();
      const double gate_m = tracks[k].kind == TrackKind::kPerson ? kPersonGate_m : kLegGate_m;
      if (legs_of(tracks[k]) > 0 && distance_m <= gate_m) pairs.emplace_back(distance_m, i, k);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<bool> label_found(labels.size(), false);
  std::vector<int> num_free(tracks.size());
  std::transform(tracks.begin(), tracks.end(), num_free.begin(), legs_of);
  int count = 0;
  for (const auto& [distance_m, i, k] : pairs) {
    if (label_found[i] || num_free[k] == 0) continue;
    label_found[i] = true;
    --num_free[k];
    ++count;
  }
  return count;
}

}  // namespace

TrackedLegResult tracked_legs_in_recording(const std::filesystem::path& log, const Labels& labels,
                                           const TrackedSetup& setup, const LegForest& forest) {
  FeatureDetector detector(setup.detector, forest);
  Tracker tracker(setup.tracker);
  TrackedLegResult result;
  result.num_scans = for_each_scan(log, [&](const LaserScan& scan) {
    const std::vector<Track>& tracks = tracker.update(scan, detector.detect(scan));
    result.num_tracks_of_scan.push_back(static_cast<int>(
        std::count_if(tracks.begin(), tracks.end(), [](const Track& track) { return legs_of(track) > 0; })));
    result.num_tracks += result.num_tracks_of_scan.back();
    const auto found = labels.find(static_cast<int>(scan.index));
    if (found == labels.end()) return;
    result.num_labels += static_cast<int>(found->second.size());
    result.num_found += num_found(found->second, tracks);
  });
  return result;
}

}  // namespace scanbed::bench
