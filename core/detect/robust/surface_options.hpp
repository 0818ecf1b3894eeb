// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/angles.hpp"

namespace scanbed {

/// How the preset `robust` cuts a scan into surfaces, and at what prices it explains them by lines and arcs.
///
/// A piece is worth its price where it saves as much chi squared (in units of range noise) against what else
/// would explain its points.
struct SurfaceOptions {
  double min_gap_m = 0.05;           ///< neighbours nearer than this plus 3 sigma lie on one surface ...
  double gap_spacings = 1.7;         ///< ... widened by so many spacings of beams at their range
  double max_grazing_step_m = 0.75;  ///< between beams of a wall seen at grazing incidence
  int max_speck_beams = 3;           ///< so many nearer or missing beams do not cut a surface
  double min_noise_m = 0.003;        ///< of the sigma of ranges that is estimated from each scan
  double max_noise_m = 0.03;
  double noise_ratio = 0.0;  ///< so much sigma a metre of range comes on top; of lasers that triangulate .01
  double noise_inflation = 1.15;  ///< recorded noise has heavier tails than a Gaussian of the same width
  double line_price = 14.0;
  double arc_price = 18.0;
  double clutter_price = 9.0;        ///< of a point that is given up
  double attached_end_price = 12.0;  ///< of an arc's end where its surface goes on
  double unsure_arc_price = 5.0;     ///< to be sure of an arc with an end that is not free ...
  double hidden_end_price = 3.0;     ///< ... on top for each at something nearer or at the edge of view ...
  double shallow_arc_price = 2.0;    ///< ... and where little of it is in view
  double shallow_arc_rad = radians(60.0);
  double doubt_ratio = 0.5;         ///< an arc has to gain this share of what a perfect one would gain ...
  double doubt_start = 6.0;         ///< ... beyond this ...
  double max_doubt = 6.0;           ///< ... but no more than this
  double max_chi2_per_point = 2.5;  ///< pieces that fit worse are not reported
  double max_direction_sigma_rad = radians(2.9);  ///< lines of a more uncertain direction are not reported
  double min_radius_m = 0.03;                     ///< thinner arcs are no circles
  double max_radius_m = 1.2;                      ///< thicker ones neither

  /// Chi squared that so many points of a good piece do not exceed.
  double max_chi2(int num_points) const { return max_chi2_per_point * num_points + 6.0; }
  void validate() const;  ///< @throws InputError naming the first field out of range
};

}  // namespace scanbed
