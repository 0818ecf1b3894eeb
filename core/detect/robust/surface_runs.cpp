// SPDX-License-Identifier: MIT
#include "core/detect/robust/surface_runs.hpp"

#include <algorithm>
#include <cmath>

#include "core/simd/double_lanes.hpp"

namespace scanbed {
namespace {

constexpr double kSteadyRatio = 0.9;  // two steps may differ by this share of their mean size

/// The bound on the distance of neighbours on one surface.
struct GapBound {
  GapBound(const Echoes& e, const SurfaceOptions& options)
      : least_m(options.min_gap_m + 3.0 * e.range_noise_m),
        per_range(options.gap_spacings * e.step_rad + 3.0 * e.noise_ratio),
        most_beams(options.max_speck_beams + 1),
        beam(e.beam.data()),
        r_m(e.range_m.data()),
        x_m(e.x_m.data()),
        y_m(e.y_m.data()) {}

  // Positive where two echoes lie near each other.
  double margin_m2(int a, int b) const {
    const double dx_m = x_m[b] - x_m[a];
    const double dy_m = y_m[b] - y_m[a];
    // Beyond a few missing beams it is no longer known what lies between.
    const int num_beams = std::min(beam[b] - beam[a], most_beams);
    const double bound_m = least_m + per_range * std::min(r_m[a], r_m[b]) * num_beams;
    return bound_m * bound_m - (dx_m * dx_m + dy_m * dy_m);
  }

  // The same of four echoes from a place on, each with the one before.
  [[gnu::always_inline]] void find_margins_m2(int place, Quads& margin_m2) const {
    Quads x, y, r, x_before, y_before, r_before;
    IntQuads beams, beams_before;
    load(x_m + place, x);
    load(y_m + place, y);
    load(r_m + place, r);
    load(beam + place, beams);
    load(x_m + place - 1, x_before);
    load(y_m + place - 1, y_before);
    load(r_m + place - 1, r_before);
    load(beam + place - 1, beams_before);
    const Quads dx = x - x_before;
    const Quads dy = y - y_before;
    beams -= beams_before;
    const IntQuads capped = beams < most_beams ? beams : IntQuads{} + most_beams;
    const Quads nearer = r < r_before ? r : r_before;
    const Quads bound = least_m + per_range * nearer * __builtin_convertvector(capped, Quads);
    margin_m2 = bound * bound - (dx * dx + dy * dy);
  }

  double least_m;
  double per_range;
  int most_beams;
  const int* beam;
  const double* r_m;
  const double* x_m;
  const double* y_m;
};

// Whether three echoes of neighbouring beams lie on one wall at grazing incidence: two steps much alike. The
// same from either side.
bool are_steady(const Echoes& e, const SurfaceOptions& options, int first) {
  if (first < 0 || first + 2 >= e.size() || e.beam[first + 2] != e.beam[first] + 2) return false;
  const double step_m = e.range_m[first + 1] - e.range_m[first];
  const double next_step_m = e.range_m[first + 2] - e.range_m[first + 1];
  const double mean_size_m = 0.5 * (std::abs(step_m) + std::abs(next_step_m));
  return std::max(std::abs(step_m), std::abs(next_step_m)) < options.max_grazing_step_m &&
         std::abs(next_step_m - step_m) <= kSteadyRatio * mean_size_m;
}

// Whether echo k + 1 goes on as those before it did and as those after it will; where only one of these
// holds, an echo may stand alone at the end of a wall, with no surface of its own to go on with.
bool goes_on_steadily(const Echoes& e, const GapBound& bound, const SurfaceOptions& options, int k) {
  const bool as_before = are_steady(e, options, k - 1);
  const bool as_after = are_steady(e, options, k);
  if (as_before == as_after) return as_before;
  const int other = as_before ? k + 2 : k - 1;
  if (other < 0 || other >= e.size()) return true;
  return bound.margin_m2(std::min(other, k + 1), std::max(other, k)) <= 0.0;
}

// Lists those of some echoes that do not lie near the one before, behind those that are listed already;
// returns how many they are then. Jumps come when they will: kept by counting, as a processor would foresee
// them wrongly.
int list_jumps(const GapBound& bound, Stretch echoes, int num_jumps, int* jumps) {
  for (int k = echoes.first; k <= echoes.last; ++k) {
    jumps[num_jumps] = k;
    num_jumps += bound.margin_m2(k - 1, k) > 0.0 ? 0 : 1;
  }
  return num_jumps;
}

#if defined(SCANBED_HAS_AVX2)
SCANBED_AVX2 int list_jumps_avx2(const GapBound& bound, int num_echoes, int* jumps) {
  int num_jumps = 0;
  int k = 1;
  Quads margin_m2;
  for (; k + kNumQuadLanes <= num_echoes; k += kNumQuadLanes) {
    bound.find_margins_m2(k, margin_m2);
    num_jumps += list_places(bits_of(~(margin_m2 > 0.0)), k, jumps + num_jumps);
  }
  return list_jumps(bound, {k, num_echoes - 1}, num_jumps, jumps);
}
#endif

int list_jumps(InstructionSet set, const GapBound& bound, int num_echoes, int* jumps) {
#if defined(SCANBED_HAS_AVX2)
  if (set == InstructionSet::kAvx2) return list_jumps_avx2(bound, num_echoes, jumps);
#endif
  return list_jumps(bound, {1, num_echoes - 1}, 0, jumps);
}

bool all_between_are_nearer(const Echoes& e, int a, int b) {
  const double range_m = std::min(e.range_m[a], e.range_m[b]);
  return std::all_of(e.range_m.begin() + a + 1, e.range_m.begin() + b,
                     [&](double r_m) { return r_m < range_m; });
}

}  // namespace

void SurfaceSplitter::find_stretches(const Echoes& echoes, const SurfaceOptions& options) {
  const int num_echoes = echoes.size();
  const std::size_t room = num_echoes + kNumQuadLanes;
  if (jumps_.size() < room) jumps_.resize(room);
  const GapBound bound(echoes, options);
  const int num_jumps = list_jumps(instructions_, bound, num_echoes, jumps_.data());
  starts_.assign(1, 0);
  for (int i = 0; i < num_jumps; ++i) {
    if (!goes_on_steadily(echoes, bound, options, jumps_[i] - 1)) starts_.push_back(jumps_[i]);
  }
  starts_.push_back(num_echoes);
}

// The stretch on which the surface of `stretch` goes on behind a speck; -1 where there is none.
int SurfaceSplitter::continuation_of(const Echoes& echoes, const SurfaceOptions& options, int stretch) const {
  const int last = starts_[stretch + 1] - 1;
  const auto num_stretches = static_cast<int>(taken_.size());
  for (int next = stretch + 1; next < num_stretches; ++next) {
    const int candidate = starts_[next];
    if (echoes.beam[candidate] - echoes.beam[last] > options.max_speck_beams + 1) return -1;
    if (!taken_[next] && GapBound(echoes, options).margin_m2(last, candidate) > 0.0 &&
        all_between_are_nearer(echoes, last, candidate)) {
      return next;
    }
  }
  return -1;
}

void SurfaceSplitter::chain_stretches(const Echoes& echoes, const SurfaceOptions& options,
                                      SurfaceRuns& runs) {
  const auto num_stretches = static_cast<int>(starts_.size()) - 1;
  taken_.assign(num_stretches, 0);
  chain_.clear();
  int num_sorted = 0;
  for (int start = 0; start < num_stretches; ++start) {
    if (taken_[start]) continue;
    runs.begin.push_back(num_sorted);
    for (int stretch = start; stretch >= 0; stretch = continuation_of(echoes, options, stretch)) {
      taken_[stretch] = 1;
      chain_.push_back(stretch);
      num_sorted += starts_[stretch + 1] - starts_[stretch];
    }
  }
  runs.begin.push_back(num_sorted);
}

template <typename Column>
void SurfaceSplitter::sort_column(Column& column, Column& sorted) const {
  sorted.resize(order_.size());
  for (std::size_t i = 0; i < order_.size(); ++i) sorted[i] = column[order_[i]];
  std::copy(sorted.begin(), sorted.end(), column.begin() + first_moved_);
}

// Most surfaces lie as they were read; what moves is what lies behind specks.
void SurfaceSplitter::sort(Echoes& echoes) {
  auto end = static_cast<int>(chain_.size());
  int begin = 0;
  while (begin < end && chain_[begin] == begin) ++begin;
  while (begin < end && chain_[end - 1] == end - 1) --end;
  if (begin == end) return;
  first_moved_ = starts_[begin];
  order_.clear();
  for (int i = begin; i < end; ++i) {
    for (int k = starts_[chain_[i]]; k < starts_[chain_[i] + 1]; ++k) order_.push_back(k);
  }
  sort_column(echoes.beam, sorted_beams_);
  for (std::vector<double>* column : {&echoes.range_m, &echoes.x_m, &echoes.y_m, &echoes.weight_per_m2}) {
    sort_column(*column, sorted_values_);
  }
}

void SurfaceSplitter::split(Echoes& echoes, const SurfaceOptions& options, SurfaceRuns& runs) {
  runs.begin.clear();
  if (echoes.size() == 0) return;
  find_stretches(echoes, options);
  chain_stretches(echoes, options, runs);
  sort(echoes);
}

}  // namespace scanbed
