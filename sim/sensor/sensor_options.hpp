// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "core/geometry/angles.hpp"
#include "core/scan/lms_word.hpp"

namespace scanbed::sim {

using scanbed::RangeUnit;

/// How much of each effect a simulated sensor shows: 1 as its figures say, 0 nothing, 2 twice as much.
struct EffectScales {
  double noise = 1.0;    ///< times every standard deviation, those of rough surfaces too
  double bias = 1.0;     ///< times every systematic error
  double spot = 1.0;     ///< times the spot's size; 0 leaves one ray a beam, so no beam is mixed
  double dropout = 1.0;  ///< times the probability that a weak echo is lost
  double dazzle = 1.0;   ///< times the probability of being dazzled
  double sweep = 1.0;    ///< 0 measures every rotation at one instant, 1 beam after beam; nothing between
};

/// The light spot, a disc of Gaussian brightness (the diameter is that at 1 / e^2: twice the radius, four
/// standard deviations).
struct SpotOptions {
  double diameter_m = 0.0;      ///< at the sensor
  double divergence_rad = 0.0;  ///< full angle by which the spot widens
  int num_rays = 7;             ///< that stand for a spot with an edge in it: odd, 3 to 9
  double pulse_m = 0.0;         ///< echoes at most this far apart in depth blend; of those farther apart the
                                ///< strongest is measured
};

/// Random range error: variance = (sigma^2 + (sigma_ratio range)^2) (1 + weak_ratio / strength) +
/// roughness^2, where strength is that of the echo (DropoutOptions) and roughness is the surface's.
struct NoiseOptions {
  double sigma_ratio = 0.0;  ///< standard deviation over range
  double weak_ratio = 0.0;   ///< by how much the weakest echo that is surely seen adds to the variance
};

/// Systematic range error: offset + cyclic sin(2 pi range / period) + dark (1 - reflectivity)
///                         + grazing (1 - cos incidence).
struct BiasOptions {
  double offset_m = 0.0;
  double cyclic_m = 0.0;         ///< amplitude over range
  double cyclic_period_m = 2.0;  ///< of that wave
  double dark_m = 0.0;           ///< of a black surface: its weak pulse crosses the threshold later
  double grazing_m = 0.0;        ///< of a surface seen along its length
};

/// When an echo is too weak. Its strength is reflectivity cos(incidence) / range^2 over that of a surface of
/// 10 % reflectivity, seen head-on at `reach_m`. Echoes of strength 1 and more are seen, those below 1/4 are
/// lost, in between the probability of loss grows linearly.
struct DropoutOptions {
  double reach_m = std::numeric_limits<double>::infinity();  ///< infinity: no echo is too weak
  double glass_cone_rad = radians(4.0);  ///< glass returns light only this close to head-on
};

struct DazzleOptions {
  double probability = 0.0;  ///< of any one beam, by stray light
  double glint_rad = 0.0;    ///< glass this close to head-on dazzles
};

/// A simulated range sensor. The defaults are those of a SICK LMS 200 with nothing but Gaussian noise;
/// sensor_preset() has the sensors with all their effects.
struct SensorOptions {
  double fov_rad = radians(180.0);          ///< from the first beam to the last
  double step_rad = radians(0.5);           ///< with interlace 0.25, 0.5 or 1 degree
  RangeUnit unit = RangeUnit::kMillimetre;  ///< step of a range; with word_bits sets the greatest
  int word_bits = 13;                       ///< of a range: 13 reach 8.182 or 81.82 m; 14 and 15 farther
  bool exact_ranges = false;                ///< ranges are not rounded to words (but as limited)
  double min_range_m = 0.0;                 ///< nearer echoes are invalid
  double max_range_m = std::numeric_limits<double>::infinity();  ///< farther echoes are none; the words too
  double scan_period_s = 0.2;      ///< between scans: 5 Hz is what a 38400 baud link carries
  bool interlace = true;           ///< one degree a rotation: odd beams are measured one rotation later
  double rotation_s = 1.0 / 75.0;  ///< of the mirror, all the way round
  double noise_sigma_m = 0.005;    ///< Gaussian, of each range
  NoiseOptions noise;
  BiasOptions bias;
  SpotOptions spot;
  DropoutOptions dropout;
  DazzleOptions dazzle;
  EffectScales effects;
  double max_sector_s = 0.0025;  ///< while things move, beams measured within so much time are cast together,
                                 ///< at the time of their middle; used with effects.sweep only

  int num_beams() const;
  int num_rotations() const;     ///< interlaced into one scan: one per degree / step, or 1 without interlace
  double range_limit_m() const;  ///< the lesser of max_range_m and what a word holds
  double beam_period_s() const;  ///< between neighbouring beams of one rotation; 0 without effects.sweep
  double spot_diameter_m(double range_m) const;  ///< with its scale; 0 where beams are rays
  void validate() const;                         ///< @throws InputError naming the first field out of range
};

/// The same sensor without any error: exact ranges, rays instead of spots, nothing lost or dazzled, all
/// beams measured at the scan's time. Geometry, limits and scan period stay.
SensorOptions ideal_sensor(SensorOptions options);

/// Bytes of the telegram in which a SICK LMS 2xx sends so many ranges: 2 each and 10 around them.
int lms_telegram_bytes(int num_beams);

/// Time from scan to scan over a serial link (8N1: ten bits a byte): sending a telegram or turning the mirror
/// often enough, whichever takes longer. 361 beams: 190.6 ms at 38400 baud, 26.7 ms at 500 kbaud.
double lms_scan_period_s(const SensorOptions& options, double link_baud);

}  // namespace scanbed::sim
