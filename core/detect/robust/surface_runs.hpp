// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/robust/echoes.hpp"
#include "core/simd/instruction_set.hpp"

namespace scanbed {

/// Some consecutive echoes, both ends included.
struct Stretch {
  int first = 0;
  int last = 0;

  int size() const { return last - first + 1; }
};

/// Where surfaces begin in echoes that are sorted by the surface on which they probably lie.
struct SurfaceRuns {
  std::vector<int> begin;  ///< surface i is echoes begin[i] to begin[i + 1] - 1, in rising order of beams

  int num_runs() const { return begin.empty() ? 0 : static_cast<int>(begin.size()) - 1; }
  Stretch run(int i) const { return {begin[i], begin[i + 1] - 1}; }
};

/// Cuts a scan into surfaces with a bound that follows the sensor.
///
/// The bound on the distance of neighbours grows with range, noise and the beams missing in between; where a
/// wall is seen at grazing incidence, they may lie as far apart as the neighbours on both sides of them. A
/// few nearer or missing beams do not cut what agrees on both sides of them: such a speck becomes a surface
/// of its own. A mirrored scan is cut at the same places.
class SurfaceSplitter {
 public:
  explicit SurfaceSplitter(InstructionSet instructions = widest_instruction_set())
      : instructions_(instructions) {}

  /// Sorts the echoes by surface. @pre they are in the order of their beams.
  void split(Echoes& echoes, const SurfaceOptions& options, SurfaceRuns& runs);

 private:
  void find_stretches(const Echoes& echoes, const SurfaceOptions& options);
  int continuation_of(const Echoes& echoes, const SurfaceOptions& options, int stretch) const;
  void chain_stretches(const Echoes& echoes, const SurfaceOptions& options, SurfaceRuns& runs);
  void sort(Echoes& echoes);
  template <typename Column>
  void sort_column(Column& column, Column& sorted) const;

  InstructionSet instructions_;
  std::vector<int> jumps_;   ///< echoes that do not lie near the one before
  std::vector<int> starts_;  ///< of stretches without a jump, and the end of the last
  std::vector<char> taken_;  ///< stretches that belong to a surface already
  std::vector<int> chain_;   ///< the stretches, surface by surface
  std::vector<int> order_;   ///< of the echoes that move: where they come from
  int first_moved_ = 0;
  std::vector<int> sorted_beams_;
  std::vector<double> sorted_values_;
};

}  // namespace scanbed
