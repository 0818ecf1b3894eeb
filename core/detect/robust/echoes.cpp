// SPDX-License-Identifier: MIT
#include "core/detect/robust/echoes.hpp"

#include <algorithm>
#include <cmath>

#include "core/detect/full_turn.hpp"
#include "core/simd/double_lanes.hpp"

namespace scanbed {
namespace {

constexpr double kDefaultNoise_m = 0.006;
// A third difference across steps of more than so many sigma is an edge, not noise.
constexpr double kSmoothSigmas = 4.0;
constexpr int kMinDifferences = 12;
constexpr double kBinsPerSigma = 120.0;  // of a difference
// A noise that it must be possible to tell, whatever less is expected.
constexpr double kLeastGreatestNoise_m = 0.03;
constexpr double kGrazingRatio = 0.35;  // error of range per step to the neighbour
constexpr double kGrazingStep_m = 0.05;

void resize(Echoes& echoes, int num_echoes) {
  echoes.beam.resize(num_echoes);
  for (std::vector<double>* column : {&echoes.range_m, &echoes.x_m, &echoes.y_m}) column->resize(num_echoes);
}

/// Where echoes go that are read from beams.
struct EchoWriter {
  explicit EchoWriter(const LaserScan& scan, Echoes& echoes)
      : range_m(scan.range_m.data()),
        ux(echoes.directions.x().data()),
        uy(echoes.directions.y().data()),
        beam(echoes.beam.data()),
        r_m(echoes.range_m.data()),
        x_m(echoes.x_m.data()),
        y_m(echoes.y_m.data()) {}

  const double* range_m;
  const double* ux;
  const double* uy;
  int* beam;
  double* r_m;
  double* x_m;
  double* y_m;
};

// A range of 0 has no direction to fit anything to. Sums over the scan hold fourth powers of ranges
// (RayLineSums): one that is far beyond any sensor's reach would drown all the others.
constexpr double kMaxRange_m = 300.0;

// Reads the beams from the given one on; returns how many echoes there are then.
int project(const EchoWriter& to, int first_beam, int num_beams, int num_echoes) {
  for (int i = first_beam; i < num_beams; ++i) {
    const double range_m = to.range_m[i];
    // Overwritten by the next one where this is no echo.
    to.beam[num_echoes] = i;
    to.r_m[num_echoes] = range_m;
    to.x_m[num_echoes] = range_m * to.ux[i];
    to.y_m[num_echoes] = range_m * to.uy[i];
    num_echoes += range_m > 0.0 && range_m <= kMaxRange_m ? 1 : 0;
  }
  return num_echoes;
}

#if defined(SCANBED_HAS_AVX2)
SCANBED_AVX2 int project_avx2(const EchoWriter& to, int num_beams) {
  int num_echoes = 0;
  int i = 0;
  Quads range_m, ux, uy;
  for (; i + kNumQuadLanes <= num_beams; i += kNumQuadLanes) {
    load(to.range_m + i, range_m);
    load(to.ux + i, ux);
    load(to.uy + i, uy);
    const unsigned echoes = bits_of((range_m > 0.0) & (range_m <= kMaxRange_m));
    store_kept(echoes, range_m, to.r_m + num_echoes);
    store_kept(echoes, range_m * ux, to.x_m + num_echoes);
    store_kept(echoes, range_m * uy, to.y_m + num_echoes);
    num_echoes += list_places(echoes, i, to.beam + num_echoes);
  }
  return project(to, i, num_beams, num_echoes);
}
#endif

int project(InstructionSet set, const EchoWriter& to, int num_beams) {
#if defined(SCANBED_HAS_AVX2)
  if (set == InstructionSet::kAvx2) return project_avx2(to, num_beams);
#endif
  return project(to, 0, num_beams, 0);
}

// Beams without echo are far from their neighbours, no number, or not positive: no smooth run holds them.
[[gnu::always_inline]] inline void sort_into_bins_in(const double* r, int num_bins, double greatest_m,
                                                     int* bins) {
  const double smooth_step_m = kSmoothSigmas * greatest_m;
  const double bins_per_m = kBinsPerSigma / greatest_m;
  for (int k = 0; k < num_bins; ++k) {
    // By steps, which do not overflow where ranges would.
    const double a = r[k + 1] - r[k];
    const double b = r[k + 2] - r[k + 1];
    const double c = r[k + 3] - r[k + 2];
    const double bin = std::min(std::abs(c - 2.0 * b + a) * bins_per_m, NoiseHistogram::kNumBins - 1.0);
    const bool is_smooth =
        std::abs(c) + std::abs(b) + std::abs(a) <= smooth_step_m && r[k] > 0.0 && r[k] < kMaxRange_m;
    bins[k] = static_cast<int>(is_smooth ? bin : NoiseHistogram::kNoBin);
  }
}

#if defined(SCANBED_HAS_AVX2)
SCANBED_AVX2 void sort_into_bins_avx2(const double* r, int num_bins, double greatest_m, int* bins) {
  sort_into_bins_in(r, num_bins, greatest_m, bins);
}
#endif

// The lesser step of range to the neighbours where both have one sign, else less than nothing.
double grazing_step_m(const double* r_m, int k) {
  const double before_m = r_m[k] - r_m[k - 1];
  const double after_m = r_m[k + 1] - r_m[k];
  return std::max(std::min(before_m, after_m), -std::max(before_m, after_m));
}

// Lists the echoes at grazing incidence from a place on, behind those that are listed already; returns how
// many they are then.
int list_grazing(const Echoes& echoes, int first, int num_grazing, int* grazing) {
  const int num_echoes = echoes.size();
  const double* const r_m = echoes.range_m.data();
  for (int k = first; k + 1 < num_echoes; ++k) {
    grazing[num_grazing] = k;
    num_grazing += grazing_step_m(r_m, k) > kGrazingStep_m ? 1 : 0;
  }
  return num_grazing;
}

#if defined(SCANBED_HAS_AVX2)
SCANBED_AVX2 int list_grazing_avx2(const Echoes& echoes, int* grazing) {
  const double* const r_m = echoes.range_m.data();
  int num_grazing = 0;
  int k = 1;
  Quads r, r_before, r_after;
  for (; k + kNumQuadLanes < echoes.size(); k += kNumQuadLanes) {
    load(r_m + k - 1, r_before);
    load(r_m + k, r);
    load(r_m + k + 1, r_after);
    const Quads before = r - r_before;
    const Quads after = r_after - r;
    const auto rises = (before > kGrazingStep_m) & (after > kGrazingStep_m);
    const auto falls = (before < -kGrazingStep_m) & (after < -kGrazingStep_m);
    num_grazing += list_places(bits_of(rises | falls), k, grazing + num_grazing);
  }
  return list_grazing(echoes, k, num_grazing, grazing);
}
#endif

int list_grazing(InstructionSet set, const Echoes& echoes, int* grazing) {
#if defined(SCANBED_HAS_AVX2)
  if (set == InstructionSet::kAvx2) return list_grazing_avx2(echoes, grazing);
#endif
  return list_grazing(echoes, 1, 0, grazing);
}

// What is left of the noise of all ranges without the part that grows with them.
double noise_at_sensor_m(const Echoes& echoes, double noise_m) {
  if (echoes.noise_ratio == 0.0 || echoes.size() == 0) return noise_m;
  const auto range_m = Eigen::Map<const Eigen::ArrayXd>(echoes.range_m.data(), echoes.size());
  const double grown_m2 = echoes.noise_ratio * echoes.noise_ratio * range_m.square().mean();
  return std::sqrt(std::max(0.0, noise_m * noise_m - grown_m2));
}

}  // namespace

void NoiseHistogram::sort_into_bins(std::span<const double> range_m) {
  bins_.resize(range_m.size() - 3);
  const auto num_bins = static_cast<int>(bins_.size());
#if defined(SCANBED_HAS_AVX2)
  if (instructions_ == InstructionSet::kAvx2) {
    return sort_into_bins_avx2(range_m.data(), num_bins, greatest_m_, bins_.data());
  }
#endif
  sort_into_bins_in(range_m.data(), num_bins, greatest_m_, bins_.data());
}

void NoiseHistogram::count() {
  for (Counts& counts : counts_) counts.fill(0);
  const std::size_t num_pairs = bins_.size() / 2;
  for (std::size_t i = 0; i < num_pairs; ++i) {
    ++counts_[0][bins_[2 * i]];
    ++counts_[1][bins_[2 * i + 1]];
  }
  if (bins_.size() % 2 == 1) ++counts_[0][bins_.back()];
  num_counted_ = static_cast<int>(bins_.size()) - counts_[0][kNoBin] - counts_[1][kNoBin];
}

double NoiseHistogram::median_m() const {
  const auto count_of = [&](int bin) { return counts_[0][bin] + counts_[1][bin]; };
  int below = 0;
  int bin = 0;
  while (2 * (below + count_of(bin)) < num_counted_) below += count_of(bin++);
  return greatest_m_ / kBinsPerSigma * (bin + (0.5 * num_counted_ - below) / count_of(bin));
}

// The median of |x| is 0.6745 sigma; it is blind to the edges that the test for smoothness let through.
std::optional<double> NoiseHistogram::sigma_m(std::span<const double> range_m, double greatest_m) {
  greatest_m_ = std::max(greatest_m, kLeastGreatestNoise_m);
  if (range_m.size() < 3 + kMinDifferences) return std::nullopt;
  sort_into_bins(range_m);
  count();
  if (num_counted_ < kMinDifferences) return std::nullopt;
  return median_m() / 0.6745 / std::sqrt(20.0);
}

void EchoReader::read(const LaserScan& scan, const SurfaceOptions& options, Echoes& echoes) {
  echoes.directions.follow(scan);
  echoes.step_rad = std::abs(scan.geometry.step_rad);
  echoes.num_beams_to_same_direction = num_beams_to_same_direction(scan.geometry);
  const int num_beams = scan.num_beams();
  resize(echoes, num_beams);
  resize(echoes, project(instructions_, EchoWriter(scan, echoes), num_beams));
  const BeamSpan once = middle_turn(scan);
  const std::optional<double> sigma_m = noise_.sigma_m(
      std::span(scan.range_m).subspan(once.first, once.last - once.first + 1), options.max_noise_m);
  echoes.noise_ratio = options.noise_ratio;
  echoes.range_noise_m =
      std::clamp(noise_at_sensor_m(echoes, sigma_m ? options.noise_inflation * *sigma_m : kDefaultNoise_m),
                 options.min_noise_m, options.max_noise_m);
  weigh(echoes);
}

void EchoReader::weigh(Echoes& echoes) {
  const int num_echoes = echoes.size();
  echoes.weight_per_m2.assign(num_echoes, 1.0 / echoes.variance_at_m2(0.0));
  if (echoes.noise_ratio > 0.0) {
    for (int k = 0; k < num_echoes; ++k) {
      echoes.weight_per_m2[k] = 1.0 / echoes.variance_at_m2(echoes.range_m[k]);
    }
  }
  const std::size_t room = num_echoes + kNumQuadLanes;
  if (grazing_.size() < room) grazing_.resize(room);
  const int num_grazing = list_grazing(instructions_, echoes, grazing_.data());
  for (const int k : std::span(grazing_).first(num_grazing)) {
    if (echoes.beam[k + 1] - echoes.beam[k - 1] != 2) continue;
    const double error_m = kGrazingRatio * grazing_step_m(echoes.range_m.data(), k);
    echoes.weight_per_m2[k] = 1.0 / (echoes.variance_at_m2(echoes.range_m[k]) + error_m * error_m);
  }
}

}  // namespace scanbed
