// SPDX-License-Identifier: MIT
#include "core/score/track_tally.hpp"

namespace scanbed {

double TrackTally::mota() const {
  const int num_errors = num_truths - num_matches + num_false + num_switches;
  if (num_truths == 0) return num_errors == 0 ? 1.0 : 0.0;
  return 1.0 - static_cast<double>(num_errors) / num_truths;
}

double TrackTally::motp_m() const {
  return num_matches == 0 ? 0.0 : sum_error_m / num_matches;
}

double TrackTally::idf1() const {
  const int num_all = num_truths + num_identity_tracks;
  return num_all == 0 ? 1.0 : 2.0 * num_identity_true / num_all;
}

double TrackTally::switches_per_minute() const {
  return object_time_s > 0.0 ? 60.0 * num_switches / object_time_s : 0.0;
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
