// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace scanbed {
namespace {

constexpr std::array<double, LegCandidates::kNumSegmentations> kGaps_m = {0.04, 0.10, 0.16};
constexpr double kSpacings = 1.5;
constexpr int kMaxBridgedBeams = 2;
constexpr double kMaxWidth_m = 0.55;
constexpr double kMaxRange_m = 6.0;
constexpr int kMinHalvedEchoes = 4;
constexpr double kMinHalvedWidth_m = 0.08;
constexpr double kMaxHalvedWidth_m = 0.9;
constexpr double kMinNotch_m = 0.015;

}  // namespace

void LegCandidateFinder::cut(const LegBeams& beams, double gap_m, LegSegmentation& segmentation) const {
  segmentation.runs.clear();
  segmentation.width_m.clear();
  segmentation.run_of_echo.clear();
  const auto joins = [&](int k) {
    const int num_steps = beams.beam[k] - beams.beam[k - 1];
    if (num_steps > kMaxBridgedBeams + 1) return false;
    const double range_m = std::min(beams.echo_range_m[k], beams.echo_range_m[k - 1]);
    const double bound_m = gap_m + kSpacings * range_m * beams.step_rad * num_steps;
    const double dx_m = beams.echo_x_m[k] - beams.echo_x_m[k - 1];
    const double dy_m = beams.echo_y_m[k] - beams.echo_y_m[k - 1];
    return dx_m * dx_m + dy_m * dy_m < bound_m * bound_m;
  };
  const int num_echoes = beams.num_echoes();
  for (int k = 0; k < num_echoes; ++k) {
    if (k > 0 && joins(k)) {
      segmentation.runs.back().last = k;
    } else {
      segmentation.runs.push_back({k, k});
    }
    segmentation.run_of_echo.push_back(static_cast<int>(segmentation.runs.size()) - 1);
  }
  for (const EchoRun& run : segmentation.runs)
    segmentation.width_m.push_back(beams.distance_m(run.first, run.last));
}

void LegCandidateFinder::add(const LegBeams& beams, const EchoRun& run) {
  if (run.size() < 2 || beams.distance_m(run.first, run.last) > kMaxWidth_m) return;
  const double range_m = (beams.sums[run.last + 1].range - beams.sums[run.first].range) / run.size();
  if (range_m <= kMaxRange_m) found_.push_back(run);
}

// The deepest notch is the echo that lies farthest behind the nearest one on either side.
void LegCandidateFinder::halve_at_notch(const LegBeams& beams, const EchoRun& run) {
  const std::vector<double>& range_m = beams.echo_range_m;
  nearest_after_m_.resize(run.size());
  double nearest_m = range_m[run.last];
  for (int k = run.last; k >= run.first; --k) {
    nearest_m = std::min(nearest_m, range_m[k]);
    nearest_after_m_[k - run.first] = nearest_m;
  }
  int notch = -1;
  double depth_m = kMinNotch_m;
  double nearest_before_m = range_m[run.first];
  for (int k = run.first + 1; k < run.last; ++k) {
    nearest_before_m = std::min(nearest_before_m, range_m[k]);
    const double depth_here_m = range_m[k] - std::max(nearest_before_m, nearest_after_m_[k - run.first]);
    if (depth_here_m <= depth_m) continue;
    depth_m = depth_here_m;
    notch = k;
  }
  if (notch < 0) return;
  // The echo in the notch may belong to either side or to none.
  for (const int without : {0, 1}) {
    add(beams, {run.first, notch - without});
    add(beams, {notch + without, run.last});
  }
}

void LegCandidateFinder::halve_at_step(const LegBeams& beams, const EchoRun& run) {
  int before = run.first;
  double largest_m = -1.0;
  for (int k = run.first; k < run.last; ++k) {
    const double step_m = std::abs(beams.echo_range_m[k + 1] - beams.echo_range_m[k]);
    if (step_m <= largest_m) continue;
    largest_m = step_m;
    before = k;
  }
  add(beams, {run.first, before});
  add(beams, {before + 1, run.last});
}

void LegCandidateFinder::find(const LegBeams& beams, LegCandidates& candidates) {
  found_.clear();
  for (int i = 0; i < LegCandidates::kNumSegmentations; ++i) {
    LegSegmentation& segmentation = candidates.segmentations[i];
    cut(beams, kGaps_m[i], segmentation);
    for (std::size_t k = 0; k < segmentation.runs.size(); ++k) {
      const EchoRun& run = segmentation.runs[k];
      add(beams, run);
      const double width_m = segmentation.width_m[k];
      const bool is_halved =
          run.size() >= kMinHalvedEchoes && width_m >= kMinHalvedWidth_m && width_m <= kMaxHalvedWidth_m;
      if (!is_halved) continue;
      halve_at_notch(beams, run);
      halve_at_step(beams, run);
    }
  }
  std::sort(found_.begin(), found_.end(), [](const EchoRun& a, const EchoRun& b) {
    return std::tie(a.first, a.last) < std::tie(b.first, b.last);
  });
  candidates.runs.clear();
  std::unique_copy(found_.begin(), found_.end(), std::back_inserter(candidates.runs));
}

}  // namespace scanbed
