// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/features.hpp"
#include "core/geometry/pose2.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// How many beams make a turn, where the scan goes all around: all, or all but the last, which in some
/// sensors points where the first does. 0 where it has less than a turn, or fewer than 8 beams.
int num_beams_in_turn(const LaserScan& scan);

/// How many beams on a beam points the same way again, as far as this step goes.
int num_beams_to_same_direction(const ScanGeometry& geometry);

/// All beams; where they go beyond a turn, as those of an unrolled scan do, the turn in their middle, in
/// which no two point the same way.
BeamSpan middle_turn(const LaserScan& scan);

/// A scan all around has no first beam: where it happens to begin is a seam through whatever stands there.
/// Unrolls such a scan from its largest step of range on, and a quarter of a turn beyond on both sides, so
/// that whatever is found in the turn between has all its surroundings; and takes what was found back.
class FullTurn {
 public:
  /// What to detect in: the scan itself, unless it goes all around. Valid until the next call, and as long as
  /// the scan.
  const LaserScan& unroll(const LaserScan& scan);

  /// Takes features of the unrolled scan back to the scan: each once, by the scan's beams and in its frame.
  /// Of one that lies across the seam the beams are those of its larger part.
  void roll(Features& features) const;

 private:
  template <typename Feature>
  void roll(std::vector<Feature>& features) const;
  BeamSpan rolled(const BeamSpan& beams) const;
  void turn(Line& line) const;
  void turn(Circle& circle) const;
  void turn(Leg& leg) const;

  LaserScan unrolled_;
  int num_beams_ = 0;  ///< in a turn; 0 where the scan does not go all around
  int begin_ = 0;      ///< beam of the scan at which the turn begins
  int margin_ = 0;     ///< beams before it
  Pose2 X_SU_;         ///< frame U of the unrolled scan, turned to that beam, in the sensor's
};

}  // namespace scanbed
