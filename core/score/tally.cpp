// SPDX-License-Identifier: MIT
#include "core/score/tally.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanbed {
namespace {

constexpr double kBandWidth_m = 2.0;

double ratio_or_one(int part, int whole) {
  return whole == 0 ? 1.0 : static_cast<double>(part) / whole;
}

}  // namespace

double Tally::precision() const {
  return ratio_or_one(num_right, num_detections);
}

double Tally::recall() const {
  return ratio_or_one(num_found, num_truths);
}

double Tally::rms_error_m() const {
  return num_right == 0 ? 0.0 : std::sqrt(sum_squared_error_m2 / num_right);
}

Tally& Tally::operator+=(const Tally& other) {
  num_truths += other.num_truths;
  num_found += other.num_found;
  num_detections += other.num_detections;
  num_right += other.num_right;
  num_neither += other.num_neither;
  sum_squared_error_m2 += other.sum_squared_error_m2;
  return *this;
}

double RangeBand::recall() const {
  return ratio_or_one(num_found, num_truths);
}

KindScore::KindScore() {
  for (std::size_t i = 0; i < bands.size(); ++i) {
    bands[i].from_m = kBandWidth_m * static_cast<double>(i);
    bands[i].to_m = bands[i].from_m + kBandWidth_m;
  }
  bands.back().to_m = std::numeric_limits<double>::infinity();
}

void KindScore::count_truth(double distance_m, bool found) {
  const auto band =
      static_cast<std::size_t>(std::min(distance_m / kBandWidth_m, static_cast<double>(bands.size() - 1)));
  ++bands[band].num_truths;
  ++tally.num_truths;
  if (!found) return;
  ++bands[band].num_found;
  ++tally.num_found;
}

KindScore& KindScore::operator+=(const KindScore& other) {
  tally += other.tally;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    bands[i].num_truths += other.bands[i].num_truths;
    bands[i].num_found += other.bands[i].num_found;
  }
  return *this;
}

std::optional<double> Scores::false_per_scan(const KindScore& kind) const {
  if (num_scans == 0) return std::nullopt;
  return static_cast<double>(kind.tally.num_detections - kind.tally.num_right) / num_scans;
}

std::optional<double> Scores::false_per_scan(const TrackTally& tracks) const {
  if (num_scans == 0) return std::nullopt;
  return static_cast<double>(tracks.num_false) / num_scans;
}

}  // namespace scanbed
