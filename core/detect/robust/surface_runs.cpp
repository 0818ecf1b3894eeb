// SPDX-License-Identifier: MIT
#include "core/detect/robust/surface_runs.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed {
namespace {

constexpr double kSteadyRatio = 0.9;  // a step may differ from the last ones by this share of them

bool are_near(const Echoes& e, const SurfaceOptions& options, int a, int b) {
  const double distance_m2 = (e.point_m(b) - e.point_m(a)).squaredNorm();
  const int num_steps = e.beam[b] - e.beam[a];
  const double bound_m = options.min_gap_m + 3.0 * e.range_noise_m +
                         options.gap_spacings * std::min(e.range_m[a], e.range_m[b]) * e.step_rad * num_steps;
  return distance_m2 < bound_m * bound_m;
}

bool is_steady(double step_m, double expected_m, const SurfaceOptions& options) {
  return std::abs(step_m) < options.max_grazing_step_m &&
         std::abs(step_m - expected_m) <= kSteadyRatio * std::abs(expected_m);
}

// Whether echo k + 1 goes on as the echoes since `first` did, or where they are too few, as those after it
// will.
bool goes_on_steadily(const Echoes& e, const SurfaceOptions& options, int first, int k) {
  if (e.beam[k + 1] != e.beam[k] + 1) return false;
  const double step_m = e.range_m[k + 1] - e.range_m[k];
  if (k > first) {
    const int before = std::max(first, k - 2);
    return is_steady(step_m, (e.range_m[k] - e.range_m[before]) / (e.beam[k] - e.beam[before]), options);
  }
  const bool next_confirms = k + 2 < e.size() && e.beam[k + 2] == e.beam[k] + 2;
  return next_confirms && is_steady(step_m, e.range_m[k + 2] - e.range_m[k + 1], options);
}

bool all_between_are_nearer(const Echoes& e, int a, int b) {
  const double range_m = std::min(e.range_m[a], e.range_m[b]);
  return std::all_of(e.range_m.begin() + a + 1, e.range_m.begin() + b,
                     [&](double r_m) { return r_m < range_m; });
}

}  // namespace

void SurfaceSplitter::find_stretches(const Echoes& echoes, const SurfaceOptions& options) {
  starts_.clear();
  for (int k = 0; k < echoes.size(); ++k) {
    const bool joins = k > 0 && (are_near(echoes, options, k - 1, k) ||
                                 goes_on_steadily(echoes, options, starts_.back(), k - 1));
    if (!joins) starts_.push_back(k);
  }
  starts_.push_back(echoes.size());
}

// The stretch on which the surface of `stretch` goes on behind a speck; -1 where there is none.
int SurfaceSplitter::continuation_of(const Echoes& echoes, const SurfaceOptions& options, int stretch) const {
  const int last = starts_[stretch + 1] - 1;
  const auto num_stretches = static_cast<int>(taken_.size());
  for (int next = stretch + 1; next < num_stretches; ++next) {
    const int candidate = starts_[next];
    if (echoes.beam[candidate] - echoes.beam[last] > options.max_speck_beams + 1) return -1;
    if (!taken_[next] && are_near(echoes, options, last, candidate) &&
        all_between_are_nearer(echoes, last, candidate)) {
      return next;
    }
  }
  return -1;
}

void SurfaceSplitter::split(const Echoes& echoes, const SurfaceOptions& options, SurfaceRuns& runs) {
  runs.order.clear();
  runs.begin.clear();
  if (echoes.size() == 0) return;
  find_stretches(echoes, options);
  const auto num_stretches = static_cast<int>(starts_.size()) - 1;
  taken_.assign(num_stretches, 0);
  for (int start = 0; start < num_stretches; ++start) {
    if (taken_[start]) continue;
    runs.begin.push_back(static_cast<int>(runs.order.size()));
    for (int stretch = start; stretch >= 0; stretch = continuation_of(echoes, options, stretch)) {
      taken_[stretch] = 1;
      for (int k = starts_[stretch]; k < starts_[stretch + 1]; ++k) runs.order.push_back(k);
    }
  }
  runs.begin.push_back(static_cast<int>(runs.order.size()));
}

}  // namespace scanbed
