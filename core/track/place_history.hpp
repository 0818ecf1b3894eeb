// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>

namespace scanbed {

/// Where something was over the last seconds, thinned to a fixed number of entries.
class PlaceHistory {
 public:
  void add(double time_s, const Eigen::Vector2d& p_m, double window_s);

  /// Moves all of it, where something else is to be followed than was so far.
  void shift(const Eigen::Vector2d& by_m);

  /// Distance from the mean of the oldest third of the window to the mean of the newest; 0 with fewer than 3
  /// entries.
  double net_displacement_m() const;

  /// From the oldest entry to the newest.
  double span_s() const;

 private:
  static constexpr int kCapacity = 24;
  struct Entry {
    double time_s = 0.0;
    Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
  };

  const Entry& entry(int i) const { return entries_[(first_ + i) % kCapacity]; }
  Eigen::Vector2d mean_m(int from, int count) const;

  std::array<Entry, kCapacity> entries_;
  int first_ = 0;
  int size_ = 0;
};

}  // namespace scanbed
