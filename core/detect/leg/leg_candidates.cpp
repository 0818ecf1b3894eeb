// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_candidates.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace scanbed {
namespace {

constexpr std::array<double, LegCandidates::kNumSegmentations> kGaps_m = {0.04, 0.10, 0.16};
constexpr int kJoined = 1;  // the segmentation in which what is too wide holds no leg
constexpr double kSpacings = 1.5;
constexpr int kMaxBridgedBeams = 2;
constexpr double kMaxWidth_m = 0.55;
constexpr double kMaxLegRange_m = 6.0;
constexpr int kMinHalvedEchoes = 4;
constexpr double kMinHalvedWidth_m = 0.08;
constexpr double kMaxHalvedWidth_m = 0.9;
constexpr double kMinNotch_m = 0.015;
constexpr std::size_t kMaxInRun = 7;  ///< candidates

// Lists the echoes that may lie behind a gap, and returns how many they are: all whose beam before has none,
// and all that lie too far from it by single precision, with a margin far above its rounding.
[[gnu::always_inline]] inline int list_suspects_in(const LegBeams& beams, int* suspects) {
  constexpr float kMargin = 0.998F;
  const auto per_range = static_cast<float>(kSpacings * beams.step_rad);
  const auto gap_m = static_cast<float>(kGaps_m.front());
  Floats x, y, range, x_before, y_before, range_before;
  int num_suspects = 0;
  int num_echoes = beams.num_beams > 0 && beams.range_m[0] < LegBeams::kNothing_m ? 1 : 0;
  for (int begin = 1; begin < beams.num_beams; begin += kNumLanes) {
    load(beams.x_m.data() + begin, x);
    load(beams.y_m.data() + begin, y);
    load(beams.range_m.data() + begin, range);
    load(beams.x_m.data() + begin - 1, x_before);
    load(beams.y_m.data() + begin - 1, y_before);
    load(beams.range_m.data() + begin - 1, range_before);
    const Floats dx = x - x_before;
    const Floats dy = y - y_before;
    lower(range_before, range);
    const Floats bound = gap_m + per_range * range_before;
    const Ints is_echo = range < LegBeams::kNothing_m;
    const unsigned echoes = bits_of(is_echo);
    unsigned left = bits_of(is_echo & (dx * dx + dy * dy > kMargin * bound * bound));
    for (; left != 0; left &= left - 1) {
      const unsigned before = (left & -left) - 1;
      suspects[num_suspects++] = num_echoes + std::popcount(echoes & before);
    }
    num_echoes += std::popcount(echoes);
  }
  return num_suspects;
}

#if defined(SCANBED_HAS_AVX2)
SCANBED_AVX2 int list_suspects_avx2(const LegBeams& beams, int* suspects) {
  return list_suspects_in(beams, suspects);
}
#endif

int list_suspects(InstructionSet set, const LegBeams& beams, int* suspects) {
#if defined(SCANBED_HAS_AVX2)
  if (set == InstructionSet::kAvx2) return list_suspects_avx2(beams, suspects);
#endif
  return list_suspects_in(beams, suspects);
}

// Writes whole blocks: what reaches into the next run is written over by that.
void number_echoes(int num_echoes, LegSegmentation& segmentation) {
  segmentation.run_of_echo.resize(num_echoes + kNumLanes);
  int* const run_of_echo = segmentation.run_of_echo.data();
  Ints number{};
  for (const auto [first, last] : segmentation.runs) {
    for (int k = first; k <= last; k += kNumLanes) store(number, run_of_echo + k);
    number += 1;
  }
  segmentation.run_of_echo.resize(num_echoes);
}

// In the order of runs.
std::uint64_t key_of(const EchoRun& run) {
  return static_cast<std::uint64_t>(run.first) << 32 | static_cast<std::uint32_t>(run.last);
}

// Merges two lists in rising order. Without a jump, as nothing foretells which list goes on.
void merge(std::span<const EchoRun> a, std::span<const EchoRun> b, EchoRun* merged) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() && j < b.size()) {
    const bool is_b = key_of(b[j]) < key_of(a[i]);
    *merged++ = is_b ? b[j] : a[i];
    i += is_b ? 0 : 1;
    j += is_b ? 1 : 0;
  }
  merged = std::copy(a.begin() + static_cast<std::ptrdiff_t>(i), a.end(), merged);
  std::copy(b.begin() + static_cast<std::ptrdiff_t>(j), b.end(), merged);
}

// Keeps each once, of a list in rising order; without a jump too.
void drop_repeated(std::vector<EchoRun>& runs) {
  std::size_t num_kept = 0;
  std::uint64_t before = std::numeric_limits<std::uint64_t>::max();
  for (const EchoRun run : runs) {
    const std::uint64_t key = key_of(run);
    num_kept += key != before ? 1 : 0;
    before = key;
    runs[num_kept - 1] = run;
  }
  runs.resize(num_kept);
}

// The echo before the largest step of range.
int largest_step(const LegBeams& beams, const EchoRun& run) {
  int before = run.first;
  double largest_m = -1.0;
  for (int k = run.first; k < run.last; ++k) {
    const double step_m = std::abs(beams.echo_range_m[k + 1] - beams.echo_range_m[k]);
    before = step_m > largest_m ? k : before;
    largest_m = std::max(largest_m, step_m);
  }
  return before;
}

}  // namespace

// All that the finest segmentation cuts; the others cut at some of them.
void LegCandidateFinder::find_gaps(const LegBeams& beams) {
  gaps_.clear();
  const std::size_t room = beams.beam.size();
  if (suspects_.size() < room) suspects_.resize(room);
  const int num_suspects = list_suspects(instructions_, beams, suspects_.data());
  for (const int k : std::span(suspects_).first(num_suspects)) {
    if (k == 0) continue;
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
  std::vector<EchoRun>& runs = segmentation.runs;
  runs.resize(gaps_.size() + 1);
  std::size_t num_runs = 0;
  int first = 0;
  for (const Gap& gap : gaps_) {
    const bool is_cut = gap.excess_m >= gap_m;
    runs[num_runs] = {first, gap.after - 1};
    num_runs += is_cut ? 1 : 0;
    first = is_cut ? gap.after : first;
  }
  runs[num_runs] = {first, beams.num_echoes() - 1};
  num_runs += beams.num_echoes() > 0 ? 1 : 0;
  runs.resize(num_runs);
  segmentation.width_m.resize(num_runs);
  for (std::size_t i = 0; i < num_runs; ++i) {
    segmentation.width_m[i] = beams.distance_m(runs[i].first, runs[i].last);
  }
  number_echoes(beams.num_echoes(), segmentation);
}

// Without a jump, as nothing foretells which runs are candidates; there is room.
void LegCandidateFinder::add(const CutScan& scan, const EchoRun& run) {
  const LegBeams& beams = scan.beams;
  const double middle_m = (beams.echo_range_m[run.first] + beams.echo_range_m[run.last]) / 2;
  const bool is_run = run.size() >= 2;
  const bool is_narrow = beams.distance_m(run.first, run.last) <= kMaxWidth_m;
  const bool is_free = scan.joined.width_of((run.first + run.last) / 2) <= kMaxWidth_m;
  const bool is_close = middle_m <= kMaxLegRange_m;
  found_[num_found_] = run;
  num_found_ += is_run && is_narrow && is_free && is_close ? 1 : 0;
}

// The echo that lies farthest behind the nearest one on either side; -1 if none lies far enough.
int LegCandidateFinder::deepest_notch(const LegBeams& beams, const EchoRun& run) {
  const double* range_m = beams.echo_range_m.data();
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
    notch = depth_here_m > depth_m ? k : notch;
    depth_m = std::max(depth_m, depth_here_m);
  }
  return notch;
}

// Adds the halves in rising order.
void LegCandidateFinder::halve(const CutScan& scan, const EchoRun& run) {
  const auto [first, last] = run;
  const int step = largest_step(scan.beams, run);
  const int notch = deepest_notch(scan.beams, run);
  if (notch < 0) {
    add(scan, {first, step});
    add(scan, run);
    add(scan, {step + 1, last});
    return;
  }
  // The echo in the notch may belong to either side or to none.
  add(scan, {first, std::min(step, notch - 1)});
  add(scan, {first, std::clamp(step, notch - 1, notch)});
  add(scan, {first, std::max(step, notch)});
  add(scan, run);
  add(scan, {std::min(step + 1, notch), last});
  add(scan, {std::clamp(step + 1, notch, notch + 1), last});
  add(scan, {std::max(step + 1, notch + 1), last});
}

void LegCandidateFinder::find_in(const CutScan& scan, const EchoRun& run, double width_m) {
  const EchoRun& joined = scan.joined.run_of(run.first);
  const bool is_part_of_wide = joined.last >= run.last && scan.joined.width_of(run.first) > kMaxWidth_m;
  if (is_part_of_wide) return;
  const bool is_halved =
      run.size() >= kMinHalvedEchoes && width_m >= kMinHalvedWidth_m && width_m <= kMaxHalvedWidth_m;
  if (is_halved) {
    halve(scan, run);
  } else {
    add(scan, run);
  }
}

// What the coarser segmentations cut otherwise is all that they add.
void LegCandidateFinder::find(const LegBeams& beams, LegCandidates& candidates) {
  candidates.runs.clear();
  find_gaps(beams);
  for (int i = 0; i < LegCandidates::kNumSegmentations; ++i)
    cut(beams, kGaps_m[i], candidates.segmentations[i]);
  const CutScan scan{beams, candidates.segmentations[kJoined]};
  for (int i = 0; i < LegCandidates::kNumSegmentations; ++i) {
    const LegSegmentation& segmentation = candidates.segmentations[i];
    const std::size_t room = kMaxInRun * segmentation.runs.size();
    if (found_.size() < room) found_.resize(room);
    num_found_ = 0;
    for (std::size_t k = 0; k < segmentation.runs.size(); ++k) {
      const EchoRun& run = segmentation.runs[k];
      const bool is_known = i > 0 && candidates.segmentations[i - 1].has(run);
      if (!is_known) find_in(scan, run, segmentation.width_m[k]);
    }
    merged_.resize(candidates.runs.size() + num_found_);
    merge(candidates.runs, std::span(found_).first(num_found_), merged_.data());
    std::swap(candidates.runs, merged_);
  }
  drop_repeated(candidates.runs);
  const bool is_seen_twice = beams.turn.first > 0;
  if (!is_seen_twice) return;
  std::erase_if(candidates.runs, [&](const EchoRun& run) {
    return !beams.counts({beams.beam[run.first], beams.beam[run.last]});
  });
}

}  // namespace scanbed
