// SPDX-License-Identifier: MIT
#include "sim/sensor/simulated_lms.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "core/errors/input_error.hpp"
#include "core/score/visibility.hpp"
#include "sim/engine/engine.hpp"
#include "sim/planar/planar_engine.hpp"
#include "sim/planar/ray_caster.hpp"
#include "sim/sensor/lms_model.hpp"
#include "sim/sensor/truth_maker.hpp"

namespace scanbed::sim {
namespace {

SimulationOptions validated(const SimulationOptions& options) {
  options.lms.validate();
  require(options.duration_s > 0.0 && options.duration_s <= 1e6, "simulation.duration_s", options.duration_s,
          "(0, 1e6]");
  return options;
}

ScanGeometry geometry_of(const LmsOptions& lms) {
  ScanGeometry geometry;
  geometry.num_beams = lms.num_beams();
  geometry.first_rad = -0.5 * lms.fov_rad;
  geometry.step_rad = lms.step_rad;
  geometry.max_range_m = lms_max_range_m(lms.unit);
  geometry.timing.num_rotations = lms.num_rotations();
  geometry.timing.rotation_s = lms.rotation_s;
  geometry.timing.step_s = 0.0;  // here a rotation is measured at one instant
  return geometry;
}

}  // namespace

struct SimulatedLms::Impl {
  Impl(World&& description, const SimulationOptions& given);
  void measure_rotation(int rotation, double time_s);
  void write(LaserScan& scan, double time_s) const;

  SimulationOptions options;
  World world;
  std::unique_ptr<Engine> engine;
  ScanGeometry geometry;
  LmsModel model;
  std::vector<RayCaster> casters;  ///< one for each rotation
  TruthMaker truth_maker;
  std::vector<std::uint16_t> words;
  std::int64_t num_scans;
  std::int64_t next_scan = 0;
  WorldState state;
};

SimulatedLms::Impl::Impl(World&& description, const SimulationOptions& given)
    : options(validated(given)),
      world(std::move(description)),
      engine(std::make_unique<PlanarEngine>(world)),
      geometry(geometry_of(options.lms)),
      model(options.lms, options.seed),
      truth_maker(engine->objects(), geometry.num_beams),
      words(geometry.num_beams),
      // The slack keeps 0.3 s at 0.1 s from having a fourth scan: 0.3 / 0.1 is a little less than 3.
      num_scans(static_cast<std::int64_t>(std::ceil(options.duration_s / options.lms.scan_period_s - 1e-9))),
      state(engine->state()) {
  const int stride = geometry.timing.num_rotations;
  for (int first = 0; first < stride; ++first) casters.emplace_back(geometry, BeamSubset{first, stride});
}

void SimulatedLms::Impl::measure_rotation(int rotation, double time_s) {
  engine->advance_to(time_s);
  if (rotation == 0) {
    state = engine->state();
    truth_maker.begin(engine->state().X_WR * world.robot.X_RS);
  }
  const Pose2 X_LS = engine->X_LS();
  RayCaster& caster = casters[rotation];
  caster.cast(engine->slice(), X_LS);
  truth_maker.add_rotation(caster, engine->slice(), X_LS, geometry.max_range_m);
  for (int i = 0; i < caster.num_beams(); ++i) {
    const int beam = caster.scan_beam(i);
    words[beam] = model.measure(caster.range_m(i), next_scan, beam);
  }
}

void SimulatedLms::Impl::write(LaserScan& scan, double time_s) const {
  scan.index = next_scan;
  scan.time_s = time_s;
  scan.geometry = geometry;
  scan.X_OR.reset();
  scan.source.clear();
  scan.range_m.resize(words.size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    scan.range_m[i] = decode_lms_word(words[i], options.lms.unit);
  }
}

SimulatedLms::SimulatedLms(World world, const SimulationOptions& options)
    : impl_(std::make_unique<Impl>(std::move(world), options)) {}

SimulatedLms::~SimulatedLms() = default;

const ScanGeometry& SimulatedLms::geometry() const {
  return impl_->geometry;
}

bool SimulatedLms::next(LaserScan& scan, Seconds /*timeout*/) {
  Impl& s = *impl_;
  if (s.next_scan >= s.num_scans) return false;
  const double time_s = static_cast<double>(s.next_scan) * s.options.lms.scan_period_s;
  for (int rotation = 0; rotation < s.geometry.timing.num_rotations; ++rotation) {
    s.measure_rotation(rotation, time_s + rotation * s.options.lms.rotation_s);
  }
  s.truth_maker.finish();
  s.write(scan, time_s);
  classify_visibility(s.truth_maker.truth(), scan);
  ++s.next_scan;
  return true;
}

const Truth* SimulatedLms::truth() const {
  return impl_->next_scan > 0 ? &impl_->truth_maker.truth() : nullptr;
}

const World& SimulatedLms::world() const {
  return impl_->world;
}

const WorldState& SimulatedLms::state() const {
  return impl_->state;
}

}  // namespace scanbed::sim
