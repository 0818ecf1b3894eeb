// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/robust/echoes.hpp"

namespace scanbed {

/// Some consecutive places of SurfaceRuns::order, both ends included.
struct Stretch {
  int first = 0;
  int last = 0;

  int size() const { return last - first + 1; }
};

/// Echoes sorted by the surface on which they probably lie.
struct SurfaceRuns {
  std::vector<int> order;  ///< indices into Echoes; each occurs once
  std::vector<int>
      begin;  ///< surface i is order[begin[i]] to order[begin[i + 1] - 1], in rising order of beams

  int num_runs() const { return begin.empty() ? 0 : static_cast<int>(begin.size()) - 1; }
  Stretch run(int i) const { return {begin[i], begin[i + 1] - 1}; }
};

/// Cuts a scan into surfaces with a bound that follows the sensor.
///
/// The bound on the distance of neighbours grows with range, noise and the beams missing in between; where a
/// wall is seen at grazing incidence, steps may grow as they did before. A few nearer or missing beams
/// do not cut what agrees on both sides of them: such a speck becomes a surface of its own.
class SurfaceSplitter {
 public:
  void split(const Echoes& echoes, const SurfaceOptions& options, SurfaceRuns& runs);

 private:
  void find_stretches(const Echoes& echoes, const SurfaceOptions& options);
  int continuation_of(const Echoes& echoes, const SurfaceOptions& options, int stretch) const;

  std::vector<int> starts_;  ///< of stretches without a jump, and the end of the last
  std::vector<char> taken_;  ///< stretches that belong to a surface already
};

}  // namespace scanbed
