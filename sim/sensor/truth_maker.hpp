// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/scan/truth.hpp"
#include "sim/planar/planar_slice.hpp"
#include "sim/planar/ray_caster.hpp"
#include "sim/planar/slice_objects.hpp"
#include "sim/sensor/ideal_returns.hpp"

namespace scanbed::sim {

/// Gathers the truth of one scan from its pieces, each cast at its own time.
class TruthMaker {
 public:
  TruthMaker(const std::vector<SliceObject>& objects, int num_beams);

  /// Begins a scan that starts with the sensor at X_WS.
  void begin(const Pose2& X_WS);

  /// Adds a piece of the scan, in the order of time: which beams are measured then, and where things were
  /// from a sensor at X_LS.
  void add_piece(BeamSubset beams, const PlanarSlice& slice, const Pose2& X_LS);

  /// Takes over what all beams met; returns beyond `max_range_m` count as none. Counts clean beams and puts
  /// each object where it was at the time of its middle clean beam (without one: at the time of the first
  /// piece).
  void finish(const IdealReturns& returns, double max_range_m);

  Truth& truth() { return truth_; }
  const Truth& truth() const { return truth_; }

 private:
  /// Where an object was at the time of one piece of the scan, in the frame L of its slice.
  struct Place {
    Eigen::Vector2d a_m = Eigen::Vector2d::Zero();  ///< centre, or one end
    Eigen::Vector2d b_m = Eigen::Vector2d::Zero();  ///< the other end
    bool is_cut = false;                            ///< by the laser's plane; else it is nowhere
  };

  /// A pose whose sine and cosine are known: of all the places only few are asked for.
  struct Transform {
    Eigen::Vector2d p_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d heading = Eigen::Vector2d::UnitX();

    Eigen::Vector2d operator*(const Eigen::Vector2d& p) const {
      return p_m + Eigen::Vector2d(heading.x() * p.x() - heading.y() * p.y(),
                                   heading.y() * p.x() + heading.x() * p.y());
    }
  };

  void take_beams(const IdealReturns& returns, double max_range_m);
  void find_middle_pieces();

  Truth truth_;
  std::vector<std::vector<Place>> places_;  ///< [piece][object]
  std::vector<Transform> X_SL_;             ///< [piece]
  int num_pieces_ = 0;
  std::vector<int> piece_of_beam_;
  std::vector<int> num_seen_;      ///< while finishing: clean beams so far, of each object
  std::vector<int> middle_piece_;  ///< in which each object's middle clean beam was measured
};

}  // namespace scanbed::sim
