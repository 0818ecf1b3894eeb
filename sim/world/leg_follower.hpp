// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/detect/features.hpp"
#include "sim/world/drive_plan.hpp"

namespace scanbed::sim {

/// Steers a robot after a pair of legs, one scan after the other.
///
/// It takes up the pair of detected legs nearest to the laser, then keeps to whatever pair, or else single
/// leg, is nearest to where that one must be by now. It steers for where the person will be when the command
/// comes into force: speed is the person's plus a part of what the distance is too large by, never backwards,
/// and the less the farther the robot has still to turn. Legs close together are often detected as one thing
/// or none, so it goes on for a while without seeing any.
///
/// It believes what the detector says: whoever walks between, or a table's legs, may lead it astray. It does
/// not look where it drives.
class LegFollower {
 public:
  LegFollower(const Robot& robot, const FollowLegs& task) : robot_(robot), task_(task) {}

  /// One scan's legs, and where it was taken.
  struct Sight {
    double time_s = 0.0;
    Pose2 X_WR;                    ///< by odometry, in any frame W that stays
    const std::vector<Leg>& legs;  ///< sensor frame
    double period_s = 0.2;         ///< the command holds from so much later, for so long
  };

  /// What to do next; to stand still while nobody is followed.
  DriveCommand update(const Sight& sight);

  /// Where the person was estimated to be at the last sight, p_WQ; empty while nobody is followed.
  std::optional<Eigen::Vector2d> person_m() const;

 private:
  struct Person {
    Eigen::Vector2d p_m;        ///< p_WQ, middle between the legs
    Eigen::Vector2d v_m_per_s;  ///< v_WQ
    double seen_s = 0.0;        ///< when legs were last seen
  };

  void take_up(const Sight& sight);
  void keep_to(const Sight& sight);
  DriveCommand steer(const Sight& sight) const;

  Robot robot_;
  FollowLegs task_;
  std::vector<Eigen::Vector2d> legs_m_;   ///< p_WQ
  std::vector<Eigen::Vector2d> pairs_m_;  ///< middles, p_WQ
  std::optional<Person> person_;
  double time_s_ = 0.0;   ///< of the last sight
  DriveCommand command_;  ///< in force since the last sight
};

}  // namespace scanbed::sim
