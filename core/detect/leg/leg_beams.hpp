// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/detect/features.hpp"
#include "core/scan/beam_directions.hpp"
#include "core/scan/laser_scan.hpp"
#include "core/simd/float_lanes.hpp"
#include "core/simd/instruction_set.hpp"

namespace scanbed {

/// A scan as the search for legs reads it: each beam, and the echoes alone.
struct LegBeams {
  static constexpr float kNothing_m = 1e3F;  ///< range of a beam without echo, and its coordinates

  // Of each beam, then padding without echoes, so that whole blocks can be read.
  std::vector<float> range_m, x_m, y_m;

  // Of each echo, in the order of beams.
  std::vector<int> beam;
  std::vector<double> echo_range_m, echo_x_m, echo_y_m;

  int num_beams = 0;
  BeamSpan turn;          ///< what is in its middle is seen once: middle_turn()
  double step_rad = 0.0;  ///< between neighbouring beams, positive

  void resize_echoes(std::size_t num_echoes);
  int num_echoes() const { return static_cast<int>(beam.size()); }
  /// Whether the middle of such a span lies in the turn: not elsewhere, a second time.
  bool counts(const BeamSpan& span) const {
    const int middle = (span.first + span.last) / 2;
    return middle >= turn.first && middle <= turn.last;
  }
  /// These beams and so many on either side, as far as there are any.
  BeamSpan around(const BeamSpan& own, int num_beside) const {
    return {std::max(0, own.first - num_beside), std::min(num_beams - 1, own.last + num_beside)};
  }
  /// Between two echoes.
  double distance_m(int a, int b) const {
    const double dx_m = echo_x_m[a] - echo_x_m[b];
    const double dy_m = echo_y_m[a] - echo_y_m[b];
    return std::sqrt(dx_m * dx_m + dy_m * dy_m);
  }
};

/// Fills LegBeams from scans; keeps the beams' directions while the geometry stays the same.
class LegBeamReader {
 public:
  static constexpr int kBlock = kNumLanes;  ///< beams are padded to a multiple of this, and by one block more

  explicit LegBeamReader(InstructionSet instructions = widest_instruction_set())
      : instructions_(instructions) {}

  /// Ranges that are not positive and finite count as no echo.
  void read(const LaserScan& scan, LegBeams& beams);

 private:
  int read_beams(const LaserScan& scan, int first_beam, int num_echoes, LegBeams& beams) const;
  SCANBED_AVX2 int read_beams_avx2(const LaserScan& scan, LegBeams& beams) const;

  InstructionSet instructions_;
  BeamDirections directions_;
};

}  // namespace scanbed
