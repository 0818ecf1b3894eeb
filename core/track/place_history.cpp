// SPDX-License-Identifier: MIT
#include "core/track/place_history.hpp"

#include <algorithm>

namespace scanbed {

void PlaceHistory::add(double time_s, const Eigen::Vector2d& p_m, double window_s) {
  const double spacing_s = window_s / (kCapacity - 1);
  if (size_ > 0) {
    const double since_newest_s = time_s - entry(size_ - 1).time_s;
    // A little less than the spacing: a source with just that period must not lose scans to rounding.
    if (since_newest_s >= 0.0 && since_newest_s < 0.999 * spacing_s) return;
  }
  while (size_ > 0 &&
         (size_ == kCapacity || time_s - entry(0).time_s > window_s || time_s < entry(0).time_s)) {
    first_ = (first_ + 1) % kCapacity;
    --size_;
  }
  entries_[(first_ + size_++) % kCapacity] = {time_s, p_m};
}

void PlaceHistory::shift(const Eigen::Vector2d& by_m) {
  for (Entry& entry : entries_) entry.p_m += by_m;
}

Eigen::Vector2d PlaceHistory::mean_m(int from, int count) const {
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  for (int i = from; i < from + count; ++i) sum_m += entry(i).p_m;
  return sum_m / count;
}

double PlaceHistory::net_displacement_m() const {
  if (size_ < 3) return 0.0;
  const int third = size_ / 3;
  return (mean_m(size_ - third, third) - mean_m(0, third)).norm();
}

double PlaceHistory::span_s() const {
  return size_ == 0 ? 0.0 : entry(size_ - 1).time_s - entry(0).time_s;
}

}  // namespace scanbed
