// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_beams.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/detect/full_turn.hpp"
#include "core/simd/double_lanes.hpp"

namespace scanbed {
namespace {

// Farther echoes say no more about a leg's surroundings.
constexpr double kMaxEcho_m = 100.0;
constexpr double kMinStep_rad = 1e-5;  // a geometry without steps must not divide by them

}  // namespace

void LegBeams::resize_echoes(std::size_t num_echoes) {
  beam.resize(num_echoes);
  for (std::vector<double>* values : {&echo_range_m, &echo_x_m, &echo_y_m}) values->resize(num_echoes);
}

void LegBeamReader::read(const LaserScan& scan, LegBeams& beams) {
  const int num_beams = scan.num_beams();
  const ScanGeometry& g = scan.geometry;
  directions_.follow(scan);
  beams.num_beams = num_beams;
  beams.turn = middle_turn(scan);
  beams.step_rad = std::abs(g.step_rad) > kMinStep_rad ? std::abs(g.step_rad) : kMinStep_rad;
  const int padded = (num_beams + kBlock - 1) / kBlock * kBlock + kBlock;
  for (std::vector<float>* values : {&beams.range_m, &beams.x_m, &beams.y_m}) {
    values->resize(padded);
    std::fill(values->begin() + num_beams, values->end(), LegBeams::kNothing_m);
  }
  beams.resize_echoes(num_beams);
  int num_echoes = 0;
#if defined(SCANBED_HAS_AVX2)
  if (instructions_ == InstructionSet::kAvx2) {
    num_echoes = read_beams_avx2(scan, beams);
  } else {
    num_echoes = read_beams(scan, 0, 0, beams);
  }
#else
  num_echoes = read_beams(scan, 0, 0, beams);
#endif
  beams.resize_echoes(num_echoes);
}

// From a beam on; before it there were so many echoes. Returns how many there are then.
int LegBeamReader::read_beams(const LaserScan& scan, int first_beam, int num_echoes, LegBeams& beams) const {
  int n = num_echoes;
  for (int i = first_beam; i < scan.num_beams(); ++i) {
    const double range_m = scan.range_m[i];
    const double x_m = range_m * directions_.x(i);
    const double y_m = range_m * directions_.y(i);
    const bool is_echo = range_m > 0.0 && range_m <= kMaxEcho_m && std::isfinite(x_m + y_m);
    beams.range_m[i] = is_echo ? static_cast<float>(range_m) : LegBeams::kNothing_m;
    beams.x_m[i] = is_echo ? static_cast<float>(x_m) : LegBeams::kNothing_m;
    beams.y_m[i] = is_echo ? static_cast<float>(y_m) : LegBeams::kNothing_m;
    // What is no echo is written over by the next one.
    beams.beam[n] = i;
    beams.echo_range_m[n] = range_m;
    beams.echo_x_m[n] = x_m;
    beams.echo_y_m[n] = y_m;
    n += is_echo ? 1 : 0;
  }
  return n;
}

#if defined(SCANBED_HAS_AVX2)
// Four beams at a time.
SCANBED_AVX2 int LegBeamReader::read_beams_avx2(const LaserScan& scan, LegBeams& beams) const {
  const Quads nothing = LegBeams::kNothing_m - Quads{};
  const auto store_beams = [&](const QuadMask& is_echo, const Quads& values, float* to) SCANBED_AVX2 {
    const __m128 narrow = _mm256_cvtpd_ps(is_echo ? values : nothing);
    std::memcpy(to, &narrow, sizeof narrow);
  };
  int n = 0;
  int i = 0;
  Quads range_m, ux, uy;
  for (; i + kNumQuadLanes <= scan.num_beams(); i += kNumQuadLanes) {
    load(&scan.range_m[i], range_m);
    load(&directions_.x()[i], ux);
    load(&directions_.y()[i], uy);
    const Quads x_m = range_m * ux;
    const Quads y_m = range_m * uy;
    const Quads off = x_m + y_m;
    const QuadMask is_finite =
        (off <= std::numeric_limits<double>::max()) & (off >= std::numeric_limits<double>::lowest());
    const QuadMask is_echo = (range_m > 0.0) & (range_m <= kMaxEcho_m) & is_finite;
    store_beams(is_echo, range_m, &beams.range_m[i]);
    store_beams(is_echo, x_m, &beams.x_m[i]);
    store_beams(is_echo, y_m, &beams.y_m[i]);
    const unsigned echoes = bits_of(is_echo);
    store_kept(echoes, range_m, &beams.echo_range_m[n]);
    store_kept(echoes, x_m, &beams.echo_x_m[n]);
    store_kept(echoes, y_m, &beams.echo_y_m[n]);
    n += list_places(echoes, i, &beams.beam[n]);
  }
  return read_beams(scan, i, n, beams);
}
#endif

}  // namespace scanbed
