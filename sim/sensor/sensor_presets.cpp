// SPDX-License-Identifier: MIT
#include "sim/sensor/sensor_presets.hpp"

#include <algorithm>
#include <array>

#include "core/errors/input_error.hpp"

namespace scanbed::sim {
namespace {

// SICK, "LMS 200 Technical Description": statistical error 5 mm (1 sigma, to 8 m, from 10 % reflectivity),
// systematic error at most 15 mm (1 to 8 m, millimetre mode), reach 10 m at 10 %. Assumed: the parts of the
// systematic error, which sum up to 15 mm at the worst; a pulse of 3.5 ns, 0.5 m of depth.
SensorOptions sick_lms200() {
  SensorOptions sensor;
  sensor.noise.weak_ratio = 0.5;
  sensor.bias = {
      .offset_m = 0.0, .cyclic_m = 0.005, .cyclic_period_m = 3.0, .dark_m = 0.005, .grazing_m = 0.005};
  sensor.spot = {.diameter_m = 0.014, .divergence_rad = 0.0044, .pulse_m = 0.5};
  sensor.dropout.reach_m = 10.0;
  sensor.dazzle.glint_rad = radians(0.3);
  return sensor;
}

/// A sensor that measures all its beams in one turn.
SensorOptions one_turn(int num_beams, double step_rad, double rotation_s) {
  SensorOptions sensor;
  sensor.fov_rad = (num_beams - 1) * step_rad;
  sensor.step_rad = step_rad;
  sensor.interlace = false;
  sensor.rotation_s = rotation_s;
  sensor.scan_period_s = rotation_s;
  return sensor;
}

// Hokuyo, URG-04LX specifications: 240 degrees in steps of 360/1024, 100 ms, 0.06 to 4.095 m, accuracy 10 mm
// to 1 m and 1 % beyond; spot about 40 mm at 4 m. It compares phases, so echoes in one spot always blend.
SensorOptions hokuyo_urg04lx() {
  SensorOptions sensor = one_turn(683, radians(360.0 / 1024.0), 0.1);
  sensor.min_range_m = 0.06;
  sensor.max_range_m = 4.095;
  sensor.noise_sigma_m = 0.003;  // assumed, as is the next: accuracy at three standard deviations
  sensor.noise = {.sigma_ratio = 0.003, .weak_ratio = 0.5};
  sensor.bias = {.cyclic_m = 0.005, .cyclic_period_m = 1.5, .dark_m = 0.010, .grazing_m = 0.005};
  sensor.spot = {.diameter_m = 0.008, .divergence_rad = 0.008, .pulse_m = 4.0};
  sensor.dropout.reach_m = 4.0;
  return sensor;
}

// Hokuyo, UTM-30LX specifications: 270 degrees in steps of 0.25, 25 ms, 0.1 to 30 m, accuracy 30 mm to 10 m,
// repeated measurements within 10 mm. Assumed: spot, pulse, reach at 10 %.
SensorOptions hokuyo_utm30lx() {
  SensorOptions sensor = one_turn(1081, radians(0.25), 0.025);
  sensor.word_bits = 15;
  sensor.min_range_m = 0.1;
  sensor.max_range_m = 30.0;
  sensor.noise_sigma_m = 0.010;
  sensor.noise = {.sigma_ratio = 0.0005, .weak_ratio = 0.5};
  sensor.bias = {.cyclic_m = 0.010, .cyclic_period_m = 4.0, .dark_m = 0.010, .grazing_m = 0.010};
  sensor.spot = {.diameter_m = 0.010, .divergence_rad = 0.010, .pulse_m = 0.6};
  sensor.dropout.reach_m = 20.0;
  return sensor;
}

// Slamtec, RPLIDAR A1M8 data sheet: 360 degrees in steps of about one, 5.5 Hz, 0.15 to 12 m, resolution 1 %
// of the range. It triangulates: its error grows with range. Assumed: spot, bias, reach.
SensorOptions rplidar_a1() {
  SensorOptions sensor = one_turn(360, radians(1.0), 1.0 / 5.5);
  sensor.word_bits = 14;
  sensor.min_range_m = 0.15;
  sensor.max_range_m = 12.0;
  sensor.noise_sigma_m = 0.001;
  sensor.noise = {.sigma_ratio = 0.01, .weak_ratio = 0.5};
  sensor.bias = {.cyclic_m = 0.010, .cyclic_period_m = 6.0, .dark_m = 0.005, .grazing_m = 0.010};
  sensor.spot = {.diameter_m = 0.005, .divergence_rad = 0.003, .pulse_m = 0.2};
  sensor.dropout.reach_m = 6.0;
  return sensor;
}

// SICK, TiM561 data sheet: 270 degrees in steps of a third, 15 Hz, 0.05 to 10 m, 8 m at 10 %, systematic
// error 60 mm, statistical error 20 mm. Assumed: spot, pulse, the parts of the systematic error.
SensorOptions sick_tim5xx() {
  SensorOptions sensor = one_turn(811, radians(1.0 / 3.0), 1.0 / 15.0);
  sensor.word_bits = 14;
  sensor.min_range_m = 0.05;
  sensor.max_range_m = 10.0;
  sensor.noise_sigma_m = 0.020;
  sensor.noise.weak_ratio = 0.5;
  sensor.bias = {.cyclic_m = 0.020, .cyclic_period_m = 5.0, .dark_m = 0.020, .grazing_m = 0.020};
  sensor.spot = {.diameter_m = 0.007, .divergence_rad = 0.015, .pulse_m = 0.6};
  sensor.dropout.reach_m = 8.0;
  return sensor;
}

SensorOptions ideal() {
  return ideal_sensor(sick_lms200());
}

struct NamedSensor {
  std::string_view name;
  SensorOptions (*make)();
};

constexpr std::array<NamedSensor, 6> kSensors = {{{"sick_lms200", sick_lms200},
                                                  {"hokuyo_urg04lx", hokuyo_urg04lx},
                                                  {"hokuyo_utm30lx", hokuyo_utm30lx},
                                                  {"rplidar_a1", rplidar_a1},
                                                  {"sick_tim5xx", sick_tim5xx},
                                                  {"ideal", ideal}}};

}  // namespace

SensorOptions sensor_preset(std::string_view name) {
  std::string known;
  for (const NamedSensor& sensor : kSensors) {
    if (sensor.name == name) return sensor.make();
    known += (known.empty() ? "" : ", ") + std::string(sensor.name);
  }
  throw InputError("sensor: no '" + std::string(name) + "'; allowed: " + known);
}

std::vector<std::string> sensor_preset_names() {
  std::vector<std::string> names(kSensors.size());
  std::transform(kSensors.begin(), kSensors.end(), names.begin(),
                 [](const NamedSensor& sensor) { return std::string(sensor.name); });
  return names;
}

}  // namespace scanbed::sim
