// SPDX-License-Identifier: MIT
#include "core/score/track_tally.hpp"

namespace scanbed {

// One division, so that a value that is a bar's to the digit is not below it.
std::optional<double> TrackTally::mota() const {
  if (num_truths == 0) return std::nullopt;
  return static_cast<double>(num_matches - num_false - num_switches) / num_truths;
}

std::optional<double> TrackTally::motp_m() const {
  if (num_matches == 0) return std::nullopt;
  return sum_error_m / num_matches;
}

std::optional<double> TrackTally::idf1() const {
  const int num_all = num_truths + num_identity_tracks;
  if (num_all == 0) return std::nullopt;
  return 2.0 * num_identity_true / num_all;
}

std::optional<double> TrackTally::switches_per_minute() const {
  if (object_time_s <= 0.0) return std::nullopt;
  return 60.0 * num_switches / object_time_s;
}

TrackTally& TrackTally::operator+=(const TrackTally& other) {
  num_truths += other.num_truths;
  num_matches += other.num_matches;
  num_false += other.num_false;
  num_neither += other.num_neither;
  num_switches += other.num_switches;
  sum_error_m += other.sum_error_m;
  object_time_s += other.object_time_s;
  num_identity_true += other.num_identity_true;
  num_identity_tracks += other.num_identity_tracks;
  return *this;
}

}  // namespace scanbed
