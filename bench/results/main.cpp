// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/results/held_out_legs.hpp"
#include "bench/results/recorded_results.hpp"
#include "bench/results/score_bins.hpp"
#include "bench/results/simulated_results.hpp"
#include "bench/results/tracked_results.hpp"
#include "core/track/track_options.hpp"

namespace scanbed::bench {
namespace {

using Values = std::vector<std::string>;  // one for each preset

void print_row(const char* recording, const char* figure, const Values& values) {
  std::printf("| %s | %s |", recording, figure);
  for (const std::string& value : values) std::printf(" %s |", value.c_str());
  std::printf("\n");
}

const DetectorOptions kPresets[] = {paper_options(), robust_options()};

std::string ratio(int part, int whole) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3f (%d of %d)", whole == 0 ? 1.0 : static_cast<double>(part) / whole,
                part, whole);
  return text;
}

std::string decimals(double value, const char* unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f%s", value, unit);
  return text;
}

void print_circles(const std::filesystem::path& data) {
  const Labels arcs = read_circle_labels(data / "columns_hall.circles.jsonl");
  const Labels maybe = read_circle_labels(data / "columns_hall.maybe.jsonl");
  Values recall;
  Values error;
  Values unmatched;
  for (const DetectorOptions& preset : kPresets) {
    const CircleResult circles = circles_in_recording(data / "columns_hall.log", arcs, maybe, preset);
    recall.push_back(ratio(circles.num_found, circles.num_labels));
    error.push_back(decimals(1000.0 * circles.median_error_m, " mm"));
    unmatched.push_back(decimals(static_cast<double>(circles.num_unmatched) / circles.num_scans, ""));
  }
  print_row("columns_hall", "recall of labelled arcs, centre within 0.10 m", recall);
  print_row("columns_hall", "median centre error", error);
  print_row("columns_hall", "unmatched column-like circles a scan", unmatched);
}

void print_legs(const std::filesystem::path& data) {
  for (const std::string name : {"legs_pos1", "legs_pos2"}) {
    Values recall;
    for (const DetectorOptions& preset : kPresets) {
      const LegResult legs =
          legs_in_recording(data / (name + ".log"), read_leg_labels(data / (name + ".legs.jsonl")), preset);
      recall.push_back(ratio(legs.num_found, legs.num_labels));
    }
    print_row(name.c_str(), "recall of labelled legs (3 points or more), within 0.15 m", recall);
  }
  Values false_legs;
  for (const DetectorOptions& preset : kPresets) {
    const LegResult nobody = legs_in_recording(data / "nobody.log", {}, preset);
    false_legs.push_back(decimals(static_cast<double>(nobody.num_detections) / nobody.num_scans, ""));
  }
  print_row("nobody", "false legs a scan, within 5 m", false_legs);
}

std::string with_interval(const std::vector<Share>& runs) {
  const Estimate share = pooled_share(runs);
  char text[64];
  std::snprintf(text, sizeof text, "%.4f (%.3f to %.3f)", share.value, share.low, share.high);
  return text;
}

void print_tracked_legs(const std::filesystem::path& data) {
  for (const std::string name : {"legs_pos1", "legs_pos2"}) {
    Values recall;
    for (const DetectorOptions& preset : kPresets) {
      const Labels labels = read_leg_labels(data / (name + ".legs.jsonl"));
      const TrackedLegResult legs = tracked_legs_in_recording(data / (name + ".log"), labels, {preset, {}});
      recall.push_back(ratio(legs.num_found, legs.num_labels));
    }
    print_row(name.c_str(),
              "with tracking: recall of labelled legs, leg within 0.15 m or person within 0.40 m", recall);
  }
  Values false_tracks;
  for (const DetectorOptions& preset : kPresets) {
    const TrackedLegResult nobody = tracked_legs_in_recording(data / "nobody.log", {}, {preset, {}});
    false_tracks.push_back(decimals(static_cast<double>(nobody.num_tracks) / nobody.num_scans, ""));
  }
  print_row("nobody", "with tracking: false tracks of people and legs a scan", false_tracks);
}

std::string recalls(const LegRate& rate) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3f at %.2f", rate.recall, rate.false_a_scan);
  return text;
}

std::string right_of(const Share& share) {
  if (share.whole == 0) return "none";
  const Estimate right = wilson_interval(share);
  char text[64];
  std::snprintf(text, sizeof text, "%.2f (%.2f to %.2f) of %d", right.value, right.low, right.high,
                share.whole);
  return text;
}

// Scores are probabilities where the shares are about the scores.
void print_score_bins(const ScoreBins& recorded, const ScoreBins& simulated) {
  std::printf(
      "\n| `robust`: score of a leg | share that are legs (95 %% interval): recordings, by forests that "
      "had not seen them | simulated worlds |\n|---|---|---|\n");
  for (int bin = 0; bin < kNumScoreBins; ++bin) {
    if (recorded[bin].whole + simulated[bin].whole == 0) continue;
    std::printf("| %.1f to %.1f | %s | %s |\n", 0.1 * bin, 0.1 * (bin + 1), right_of(recorded[bin]).c_str(),
                right_of(simulated[bin]).c_str());
  }
}

// Legs of the robust preset in worlds of all sets.
ScoreBins simulated_scores() {
  ScoreBins bins;
  for (const WorldSet worlds : kWorldSets)
    bins += simulated_results({.worlds = worlds}, robust_options()).leg_scores;
  return bins;
}

void print_held_out_legs(const std::filesystem::path& data) {
  const std::vector<double> track_scores = {0.5, TrackOptions{}.min_score, 0.7, 0.8, 0.9};
  const std::vector<HeldOutLegs> results = held_out_legs(data, track_scores);
  std::printf(
      "\n| `robust` by forests trained without the recording: recall at false a scan of nobody | legs_pos1 | "
      "legs_pos2 |\n|---|---|---|\n");
  const auto row = [&](const std::string& figure, const auto& rate_of) {
    std::printf("| %s | %s | %s |\n", figure.c_str(), recalls(rate_of(results[0])).c_str(),
                recalls(rate_of(results[1])).c_str());
  };
  for (std::size_t i = 0; i < results[0].single_scan.size(); ++i) {
    row("one scan", [i](const HeldOutLegs& r) { return r.single_scan[i]; });
  }
  row("one scan, as the preset reports", [](const HeldOutLegs& r) { return r.at_default; });
  for (std::size_t i = 0; i < track_scores.size(); ++i) {
    row("tracks of score " + decimals(track_scores[i], ""),
        [i](const HeldOutLegs& r) { return r.tracked[i]; });
  }
  ScoreBins recorded = results[0].scores;
  print_score_bins(recorded += results[1].scores, simulated_scores());
}

bool has_truths(const std::vector<Share>& recall) {
  return std::any_of(recall.begin(), recall.end(), [](const Share& run) { return run.whole > 0; });
}

void print_simulated(const SimulatedSet& set) {
  std::vector<SimulatedResult> results;
  for (const DetectorOptions& preset : kPresets) results.push_back(simulated_results(set, preset));
  char name[64];
  std::snprintf(name, sizeof name, "%s, %g mm", name_of(set.worlds), 1000.0 * set.sigma_m);
  const auto row = [&](const char* figure, const auto& value_of) {
    Values values;
    for (const SimulatedResult& result : results) values.push_back(value_of(result));
    print_row(name, figure, values);
  };
  row("circles: precision", [](const auto& r) { return with_interval(r.circle.precision); });
  row("circles: recall", [](const auto& r) { return with_interval(r.circle.recall); });
  row("circles: median centre error",
      [](const auto& r) { return decimals(1000.0 * median_of(r.center_errors_m), " mm"); });
  row("lines: precision", [](const auto& r) { return with_interval(r.line.precision); });
  row("lines: recall", [](const auto& r) { return with_interval(r.line.recall); });
  if (has_truths(results.front().leg.recall)) {
    row("legs: precision", [](const auto& r) { return with_interval(r.leg.precision); });
    row("legs: recall", [](const auto& r) { return with_interval(r.leg.recall); });
  }
  row("false circles a scan",
      [](const auto& r) { return decimals(static_cast<double>(r.num_false_circles) / r.num_scans, ""); });
  row("false legs a scan",
      [](const auto& r) { return decimals(static_cast<double>(r.num_false_legs) / r.num_scans, ""); });
}

void print_all_simulated() {
  std::printf(
      "| 200 random worlds | figure (95 %% interval over worlds) | `paper` | `robust` "
      "|\n|---|---|---|---|\n");
  for (const WorldSet worlds : kWorldSets) {
    for (const double sigma_m : {0.005, 0.012}) print_simulated({.worlds = worlds, .sigma_m = sigma_m});
  }
  std::printf("\n");
}

}  // namespace
}  // namespace scanbed::bench

int main() {
  scanbed::bench::print_all_simulated();
  const std::filesystem::path data = std::filesystem::path(SCANBED_SOURCE_DIR) / "../shared/data";
  if (!std::filesystem::exists(data)) {
    std::fprintf(stderr, "results: the recordings are not there (%s); nothing to measure\n", data.c_str());
    return 2;
  }
  try {
    std::printf("| recording | figure | `paper` | `robust` |\n|---|---|---|---|\n");
    scanbed::bench::print_circles(data);
    scanbed::bench::print_legs(data);
    scanbed::bench::print_tracked_legs(data);
    scanbed::bench::print_held_out_legs(data);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "results: %s\n", error.what());
    return 2;
  }
  return 0;
}
