// SPDX-License-Identifier: MIT
#include "sim/world/body.hpp"

#include <algorithm>
#include <string>

#include "core/random/gaussian_pair.hpp"
#include "core/random/philox.hpp"

namespace scanbed::sim {
namespace {

constexpr double kHipOverStature = 0.53;
constexpr double kCalfOverKnee = 0.70;
constexpr double kAnkleOverKnee = 0.17;
constexpr double kKneeOverCalf = 0.80;  // diameters
constexpr double kChildScale = 0.70;
constexpr double kMostSigmas = 2.5;

/// Relative standard deviations.
constexpr double kHeightSpread = 0.039;  // stature: 69 mm of 1756
constexpr double kKneeSpread = 0.035;    // of the knee's height beside the stature's
constexpr double kLegSpread = 0.076;     // calf: 9.5 mm of 125
constexpr double kSpeedSpread = 0.05;    // so that nearly all lie within 1.2 and 1.4 m/s

/// What clothing adds.
struct Cloth {
  double thickness_m;
  Material material;
};

Cloth cloth(Clothing clothing) {
  switch (clothing) {
    case Clothing::kTrousers:
      return {0.012, {.reflectivity = 0.3, .roughness_m = 0.006}};
    case Clothing::kSkirt:
      return {0.035, {.reflectivity = 0.3, .roughness_m = 0.012}};
    case Clothing::kBare:
      break;
  }
  return {0.0, {}};
}

Body scaled(Body body, double scale) {
  body.stature_m *= scale;
  body.hip_m *= scale;
  body.knee_m *= scale;
  body.calf_diameter_m *= scale;
  body.ankle_diameter_m *= scale;
  return body;
}

}  // namespace

double Body::leg_radius_m(double height_m) const {
  const double calf_m = kCalfOverKnee * knee_m;
  const double ankle_m = kAnkleOverKnee * knee_m;
  if (height_m <= calf_m) {
    const double up = std::clamp((height_m - ankle_m) / (calf_m - ankle_m), 0.0, 1.0);
    return 0.5 * (ankle_diameter_m + up * (calf_diameter_m - ankle_diameter_m));
  }
  const double up = std::min((height_m - calf_m) / (knee_m - calf_m), 1.0);
  return 0.5 * calf_diameter_m * (1.0 - (1.0 - kKneeOverCalf) * up);
}

Body mean_body(Person person) {
  if (person == Person::kMan) return {};
  Body woman{.stature_m = 1.629,
             .hip_m = kHipOverStature * 1.629,
             .knee_m = 0.438,
             .calf_diameter_m = 0.119,
             .ankle_diameter_m = 0.069};
  if (person == Person::kWoman) return woman;
  woman.speed_m_per_s = 1.1;
  return scaled(woman, kChildScale);
}

Body draw_body(Person person, std::uint64_t seed, std::string_view walker_id) {
  const RandomSource source(seed, "body." + std::string(walker_id));
  const PhiloxCounter words = source.bits(0, 0);
  const auto [height, knee] = gaussian_pair(words[0], words[1]);
  const auto [leg, speed] = gaussian_pair(words[2], words[3]);
  const auto spread = [](double sigmas, double ratio) {
    return 1.0 + ratio * std::clamp(sigmas, -kMostSigmas, kMostSigmas);
  };
  Body body = mean_body(person);
  body.stature_m *= spread(height, kHeightSpread);
  body.hip_m *= spread(height, kHeightSpread);
  body.knee_m *= spread(height, kHeightSpread) * spread(knee, kKneeSpread);
  body.calf_diameter_m *= spread(leg, kLegSpread);
  body.ankle_diameter_m *= spread(leg, kLegSpread);
  body.speed_m_per_s *= spread(speed, kSpeedSpread);
  return body;
}

void give_body(Walker& walker, const Body& body, Clothing clothing, double laser_height_m) {
  const Cloth worn = cloth(clothing);
  walker.leg_radius_m = body.leg_radius_m(laser_height_m) + worn.thickness_m;
  walker.material = worn.material;
  walker.leg_length_m = body.hip_m;
  walker.height_m = body.stature_m;
  walker.speed_m_per_s = body.speed_m_per_s;
}

}  // namespace scanbed::sim
