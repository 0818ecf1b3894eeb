// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/detect/points.hpp"
#include "core/geometry/pose2.hpp"
#include "core/scan/scan_geometry.hpp"

namespace scanbed {

/// A motion between two scans and what speaks for it.
struct ScanMatch {
  Pose2 X_AB;                    ///< sensor at scan B, in the sensor frame of scan A
  double explained_ratio = 0.0;  ///< of B's points that A can have seen: within 0.06 m of a surface of A
  bool is_trusted = false;       ///< enough points agree
};

/// Finds the motion between two scans of one still world by point-to-line ICP. What moves by itself is left
/// out as long as it is the smaller part. Keeps its storage.
///
/// @par Source  Chen & Medioni, "Object modelling by registration of multiple range images", 1992 (points to
///              tangents); Censi, "An ICP variant using a point-to-line metric", 2008. Departs: the gate
///              shrinks from round to round, residuals are weighted after Geman & McClure, and where the
///              surfaces leave a direction free (along a corridor) the motion stays what was expected.
class ScanMatcher {
 public:
  /// Takes the scan that following ones are compared with.
  void set_reference(const Points& points_A, const ScanGeometry& geometry);

  /// Matches from the expected motion; where that is not trusted, from the best of some turns around it too.
  ScanMatch match(const Points& points_B, const Pose2& expected_X_AB);

 private:
  /// Where the nearest point of A is looked for.
  struct Search {
    double gate_m = 0.0;
    int middle = 0;  ///< index of a point of A
    int window = 0;  ///< points to either side
  };
  struct Round {
    double gate_m = 0.0;
    int stride = 1;           ///< every n-th point of B takes part
    bool looks_anew = false;  ///< else the search begins at the point that the round before has found
  };

  int nearest(const Eigen::Vector2d& p_AP, const Search& search) const;
  double distance_m(const Eigen::Vector2d& p_AP, int place) const;
  int beam_of(const Eigen::Vector2d& p_AP) const;
  int place_of(const Eigen::Vector2d& p_AP) const;
  void find_normals();
  Pose2 refine(const Points& points_B, const Pose2& expected_X_AB);
  Pose2 step(const Points& points_B, const Pose2& X_AB, const Pose2& expected_X_AB, const Round& round);
  ScanMatch judge(const Points& points_B, const Pose2& X_AB, int stride) const;

  Points reference_;
  ScanGeometry geometry_;
  std::vector<int> place_of_beam_;  ///< index of the last point of A at or before each beam, or -1
  std::vector<double> nx_, ny_;     ///< unit normals of A's points; zero where the surface has none
  std::vector<int> nearest_;        ///< of each point of B, as the last round found it
};

}  // namespace scanbed
