// SPDX-License-Identifier: MIT
#include "scenarios/load/sensor_effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/geometry/angles.hpp"

namespace scanbed::scenarios {
namespace {

constexpr Allowed kSigma_m{.least = 0.0, .greatest = 0.5};
constexpr Allowed kError_m{.least = -1.0, .greatest = 1.0};
constexpr Allowed kRatio{.least = 0.0, .greatest = 100.0};
constexpr Allowed kSpot_m{.least = 0.0, .greatest = 0.2};
constexpr Allowed kSpot_deg{.least = 0.0, .greatest = 5.0};
constexpr Allowed kPulse_m{.least = 0.0, .greatest = 100.0};
constexpr Allowed kPeriod_m{.least = 0.01, .greatest = 1'000.0};
constexpr Allowed kCone_deg{.least = 0.0, .greatest = 90.0};

void load_noise(const Value& value, sim::SensorOptions& options) {
  Table noise(value);
  options.noise_sigma_m = noise.number("sigma", options.noise_sigma_m, kSigma_m);
  options.noise.sigma_ratio = noise.number("sigma_ratio", options.noise.sigma_ratio, kShare);
  options.noise.weak_ratio = noise.number("weak_ratio", options.noise.weak_ratio, kRatio);
  noise.finish();
}

void load_bias(const Value& value, sim::BiasOptions& bias) {
  Table table(value);
  bias.offset_m = table.number("offset", bias.offset_m, kError_m);
  bias.cyclic_m = table.number("cyclic", bias.cyclic_m, kError_m);
  bias.cyclic_period_m = table.number("cyclic_period", bias.cyclic_period_m, kPeriod_m);
  bias.dark_m = table.number("dark", bias.dark_m, kError_m);
  bias.grazing_m = table.number("grazing", bias.grazing_m, kError_m);
  table.finish();
}

void load_spot(const Value& value, sim::SpotOptions& spot) {
  Table table(value);
  spot.diameter_m = table.number("diameter", spot.diameter_m, kSpot_m);
  spot.divergence_rad = radians(table.number("divergence_deg", degrees(spot.divergence_rad), kSpot_deg));
  if (const auto rays = table.take("rays")) {
    spot.num_rays = static_cast<int>(rays->count({.least = 3.0, .greatest = 9.0}));
    if (spot.num_rays % 2 == 0) rays->refuse("expected an odd number: the middle ray is the beam's axis");
  }
  spot.pulse_m = table.number("pulse", spot.pulse_m, kPulse_m);
  table.finish();
}

void load_dropout(const Value& value, sim::DropoutOptions& dropout) {
  Table table(value);
  dropout.reach_m = table.number("reach", dropout.reach_m, kLength);
  dropout.glass_cone_rad =
      radians(table.number("glass_cone_deg", degrees(dropout.glass_cone_rad), kCone_deg));
  table.finish();
}

void load_dazzle(const Value& value, sim::DazzleOptions& dazzle) {
  Table table(value);
  dazzle.probability = table.number("probability", dazzle.probability, kShare);
  dazzle.glint_rad = radians(table.number("glint_deg", degrees(dazzle.glint_rad), kCone_deg));
  table.finish();
}

void load_scales(const Value& value, sim::EffectScales& effects) {
  Table table(value);
  effects.noise = table.number("noise", effects.noise, kRatio);
  effects.bias = table.number("bias", effects.bias, kRatio);
  effects.spot = table.number("spot", effects.spot, {.least = 0.0, .greatest = 10.0});
  effects.dropout = table.number("dropout", effects.dropout, kRatio);
  effects.dazzle = table.number("dazzle", effects.dazzle, kRatio);
  if (const auto sweep = table.take("sweep")) {
    effects.sweep = static_cast<double>(sweep->count({.least = 0.0, .greatest = 1.0}));
  }
  table.finish();
}

// A sensor without an effect has it only where the file says so.
void check_effect(const std::optional<Value>& section, const std::optional<Value>& scales, double scale) {
  if (!section || scale > 0.0) return;
  const auto is_it = [&](const NodeEntry& entry) { return entry.key == section->name(); };
  if (scales && std::ranges::any_of(scales->node().entries, is_it)) return;
  section->refuse(fmt::format("changes nothing: this sensor has no such effect; write effects: {{{}: 1}} too",
                              section->name()));
}

}  // namespace

void load_effects(Table& sensor, sim::SensorOptions& options) {
  const sim::EffectScales own = options.effects;
  const auto noise = sensor.take("noise");
  const auto bias = sensor.take("bias");
  const auto spot = sensor.take("spot");
  const auto dropout = sensor.take("dropout");
  const auto dazzle = sensor.take("dazzle");
  const auto scales = sensor.take("effects");
  if (noise) load_noise(*noise, options);
  if (bias) load_bias(*bias, options.bias);
  if (spot) load_spot(*spot, options.spot);
  if (dropout) load_dropout(*dropout, options.dropout);
  if (dazzle) load_dazzle(*dazzle, options.dazzle);
  if (scales) load_scales(*scales, options.effects);
  check_effect(noise, scales, own.noise);
  check_effect(bias, scales, own.bias);
  check_effect(spot, scales, own.spot);
  check_effect(dropout, scales, own.dropout);
  check_effect(dazzle, scales, own.dazzle);
}

}  // namespace scanbed::scenarios
