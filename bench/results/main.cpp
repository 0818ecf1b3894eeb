// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>
#include <filesystem>

#include "bench/results/recorded_results.hpp"

namespace scanbed::bench {
namespace {

void print_row(const char* recording, const char* figure, const std::string& value) {
  std::printf("| %s | %s | %s |\n", recording, figure, value.c_str());
}

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

void print_circles(const std::filesystem::path& data, const DetectorOptions& options) {
  const CircleResult circles =
      circles_in_recording(data / "columns_hall.log", read_circle_labels(data / "columns_hall.circles.jsonl"),
                           read_circle_labels(data / "columns_hall.maybe.jsonl"), options);
  print_row("columns_hall", "recall of labelled arcs, centre within 0.10 m",
            ratio(circles.num_found, circles.num_labels));
  print_row("columns_hall", "median centre error", decimals(1000.0 * circles.median_error_m, " mm"));
  print_row("columns_hall", "unmatched column-like circles a scan",
            decimals(static_cast<double>(circles.num_unmatched) / circles.num_scans, ""));
}

void print_legs(const std::filesystem::path& data, const DetectorOptions& options) {
  for (const char* name : {"legs_pos1", "legs_pos2"}) {
    const LegResult legs =
        legs_in_recording(data / (std::string(name) + ".log"),
                          read_leg_labels(data / (std::string(name) + ".legs.jsonl")), options);
    print_row(name, "recall of labelled legs (3 points or more), within 0.15 m",
              ratio(legs.num_found, legs.num_labels));
  }
  const LegResult nobody = legs_in_recording(data / "nobody.log", {}, options);
  print_row("nobody", "false legs a scan, within 5 m",
            decimals(static_cast<double>(nobody.num_detections) / nobody.num_scans, ""));
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
    std::printf("| recording | figure | `paper` |\n|---|---|---|\n");
    scanbed::bench::print_circles(data, scanbed::paper_options());
    scanbed::bench::print_legs(data, scanbed::paper_options());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "results: %s\n", error.what());
    return 2;
  }
  return 0;
}
