// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/geometry/pose2.hpp"
#include "sim/planar/planar_slice.hpp"

namespace scanbed::sim {

/// A SliceArc as the beams of a sensor meet it. Along the beam t u the conic is
/// alpha t^2 + 2 beta t + gamma = 0, with alpha = u' form u and beta = u' slope.
class ArcInBeams {
 public:
  ArcInBeams(const SliceArc& arc, const Pose2& X_LS);

  /// 1 / metres to the nearest point of the arc along the direction u; 0 where there is none.
  double inverse_range(const Eigen::Vector2d& u) const;

  /// Cosine of the angle between a beam that meets the arc and the surface's normal, [0, 1].
  double cos_incidence(const Eigen::Vector2d& u, double inverse_range) const;

  /// The two directions, right and left, between which all that can be met lies; empty where that may be
  /// anywhere: the sensor is inside the conic, or the conic is hardly closed.
  struct Wedge {
    Eigen::Vector2d right;
    Eigen::Vector2d left;
  };
  std::optional<Wedge> wedge() const;

  /// The same arc from a sensor that stands at p_SO, turned as before.
  ArcInBeams seen_from(const Eigen::Vector2d& p_SO) const;

  /// Where a side of the wedge touches the conic. @param u  along it, of any length.
  Eigen::Vector2d touch_m(const Eigen::Vector2d& u) const;

  int object() const { return object_; }

 private:
  bool is_on_piece(const Eigen::Vector2d& u, double inverse_range) const;

  Eigen::Matrix2d form_;
  Eigen::Vector2d slope_;
  double gamma_;
  Eigen::Vector2d along_;
  double from_, to_;  ///< of along' (t u), from the sensor
  double normal_;
  int object_;
};

}  // namespace scanbed::sim
