// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "sim/world/world.hpp"

namespace scanbed::sim {

enum class Person { kWoman, kMan, kChild };

/// What covers the shins: a wider leg with a rougher surface.
enum class Clothing { kBare, kTrousers, kSkirt };

/// The sizes of a body that a laser or a gait can tell.
struct Body {
  double stature_m = 1.756;
  double hip_m = 0.93;             ///< hip joint above the floor
  double knee_m = 0.468;           ///< tibial height
  double calf_diameter_m = 0.125;  ///< where the shin is thickest, at 70 % of the knee's height
  double ankle_diameter_m = 0.073;
  double speed_m_per_s = 1.3;  ///< preferred

  /// Of a bare shin, linear between ankle (at 17 % of the knee's height) and calf, and from the calf a fifth
  /// thinner to the knee; not thinner or thicker elsewhere.
  double leg_radius_m(double height_m) const;
};

/// The middle body of its kind.
Body mean_body(Person person);

/// A body drawn at random: every size from a normal distribution, cut off at 2.5 standard deviations; a tall
/// body is long in all its heights, a thick leg thick at calf and ankle alike. The same for the same seed and
/// id.
///
/// @par Source  Means of calf, ankle and tibial height: ANSUR II (4082 men, 1986 women). Statures and
///              standard deviations: ANSUR II, rounded. Preferred speed 1.2 to 1.4 m/s. A child is assumed to
///              be a woman of 70 % of the size.
Body draw_body(Person person, std::uint64_t seed, std::string_view walker_id);

/// Gives a walker this body: legs at the laser's height, leg length, height, speed; and clothes them.
void give_body(Walker& walker, const Body& body, Clothing clothing, double laser_height_m);

}  // namespace scanbed::sim
