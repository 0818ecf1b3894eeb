// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/results/recorded_results.hpp"

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

}  // namespace
}  // namespace scanbed::bench

int main() {
  const std::filesystem::path data = std::filesystem::path(SCANBED_SOURCE_DIR) / "../shared/data";
  if (!std::filesystem::exists(data)) {
    std::fprintf(stderr, "results: the recordings are not there (%s); nothing to measure\n", data.c_str());
    return 2;
  }
  try {
    std::printf("| recording | figure | `paper` | `robust` |\n|---|---|---|---|\n");
    scanbed::bench::print_circles(data);
    scanbed::bench::print_legs(data);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "results: %s\n", error.what());
    return 2;
  }
  return 0;
}
