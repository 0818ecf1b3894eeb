// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/scan/truth.hpp"
#include "sim/planar/planar_slice.hpp"
#include "sim/planar/ray_caster.hpp"
#include "sim/planar/slice_objects.hpp"

namespace scanbed::sim {

/// Gathers the truth of one scan from its rotations, each cast at its own time.
class TruthMaker {
 public:
  TruthMaker(const std::vector<SliceObject>& objects, int num_beams);

  /// Begins a scan that starts with the sensor at X_WS.
  void begin(const Pose2& X_WS);

  /// Adds a rotation, in the order of time: what its beams met, and where things were from a sensor at X_LS.
  /// Returns beyond `max_range_m` count as none.
  void add_rotation(const RayCaster& caster, const PlanarSlice& slice, const Pose2& X_LS, double max_range_m);

  /// Counts clean beams and puts each object where it was at the time of its middle clean beam (without one:
  /// at the scan's time).
  void finish();

  Truth& truth() { return truth_; }
  const Truth& truth() const { return truth_; }

 private:
  /// Where one rotation saw an object, sensor frame.
  struct Place {
    Eigen::Vector2d a_m = Eigen::Vector2d::Zero();  ///< centre, or one end
    Eigen::Vector2d b_m = Eigen::Vector2d::Zero();  ///< the other end
  };

  Truth truth_;
  std::vector<std::vector<Place>> places_;  ///< [rotation][object]
  int num_rotations_ = 0;
  std::vector<int> rotation_of_beam_;
  std::vector<int> num_seen_;         ///< while finishing: beams so far, of each object
  std::vector<int> middle_rotation_;  ///< in which each object's middle beam was measured
};

}  // namespace scanbed::sim
