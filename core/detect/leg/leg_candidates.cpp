// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

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

// All that the finest segmentation cuts; the others cut at some of them.
void LegCandidateFinder::find_gaps(const LegBeams& beams) {
  gaps_.clear();
  for (int k = 1; k < beams.num_echoes(); ++k) {
    const int num_steps = beams.beam[k] - beams.beam[k - 1];
    const double range_m = std::min(beams.echo_range_m[k], beams.echo_range_m[k - 1]);
    const double allowed_m = kSpacings * range_m * beams.step_rad * num_steps;
    const double excess_m = beams.distance_m(k - 1, k) - allowed_m;
    if (num_steps > kMaxBridgedBeams + 1) {
      gaps_.push_back({k, std::numeric_limits<double>::infinity()});
    } else if (excess_m >= kGaps_m.front()) {
      gaps_.push_back({k, excess_m});
    }
  }
}

void LegCandidateFinder::cut(const LegBeams& beams, double gap_m, LegSegmentation& segmentation) const {
  segmentation.runs.clear();
  segmentation.width_m.clear();
  segmentation.run_of_echo.resize(beams.num_echoes());
  int first = 0;
  const auto end_before = [&](int echo) {
    const EchoRun run{first, echo - 1};
    std::fill(segmentation.run_of_echo.begin() + run.first, segmentation.run_of_echo.begin() + echo,
              static_cast<int>(segmentation.runs.size()));
    segmentation.runs.push_back(run);
    segmentation.width_m.push_back(beams.distance_m(run.first, run.last));
    first = echo;
  };
  for (const Gap& gap : gaps_) {
    if (gap.excess_m >= gap_m) end_before(gap.after);
  }
  if (beams.num_echoes() > 0) end_before(beams.num_echoes());
}

void LegCandidateFinder::add(const LegBeams& beams, const EchoRun& run) {
  const double middle_m = (beams.echo_range_m[run.first] + beams.echo_range_m[run.last]) / 2;
  const bool is_candidate =
      run.size() >= 2 && beams.distance_m(run.first, run.last) <= kMaxWidth_m && middle_m <= kMaxRange_m;
  if (is_candidate) found_.push_back(run);
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

void LegCandidateFinder::find_in(const LegBeams& beams, const EchoRun& run, double width_m) {
  const auto num_before = static_cast<std::ptrdiff_t>(found_.size());
  add(beams, run);
  const bool is_halved =
      run.size() >= kMinHalvedEchoes && width_m >= kMinHalvedWidth_m && width_m <= kMaxHalvedWidth_m;
  if (is_halved) {
    halve_at_notch(beams, run);
    halve_at_step(beams, run);
  }
  std::sort(found_.begin() + num_before, found_.end());
}

void LegCandidateFinder::find(const LegBeams& beams, LegCandidates& candidates) {
  candidates.runs.clear();
  find_gaps(beams);
  for (int i = 0; i < LegCandidates::kNumSegmentations; ++i) {
    LegSegmentation& segmentation = candidates.segmentations[i];
    cut(beams, kGaps_m[i], segmentation);
    found_.clear();
    for (std::size_t k = 0; k < segmentation.runs.size(); ++k) {
      const EchoRun& run = segmentation.runs[k];
      const bool is_known = i > 0 && candidates.segmentations[i - 1].has(run);
      if (!is_known) find_in(beams, run, segmentation.width_m[k]);
    }
    merged_.clear();
    std::merge(candidates.runs.begin(), candidates.runs.end(), found_.begin(), found_.end(),
               std::back_inserter(merged_));
    std::swap(candidates.runs, merged_);
  }
  const auto end = std::unique(candidates.runs.begin(), candidates.runs.end());
  candidates.runs.erase(end, candidates.runs.end());
}

}  // namespace scanbed
