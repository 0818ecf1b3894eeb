// SPDX-License-Identifier: MIT
#include "sim/sensor/simulated_lms.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "core/detect/feature_detector.hpp"
#include "core/errors/input_error.hpp"
#include "core/score/visibility.hpp"
#include "sim/engine/make_engine.hpp"
#include "sim/planar/ray_caster.hpp"
#include "sim/planar/sector_culler.hpp"
#include "sim/planar/spot_caster.hpp"
#include "sim/sensor/sensor_model.hpp"
#include "sim/sensor/truth_maker.hpp"
#include "sim/world/leg_follower.hpp"

namespace scanbed::sim {
namespace {

SimulationOptions validated(const SimulationOptions& options) {
  options.lms.validate();
  require(options.duration_s > 0.0 && options.duration_s <= 1e6, "simulation.duration_s", options.duration_s,
          "(0, 1e6]");
  return options;
}

ScanGeometry geometry_of(const SensorOptions& sensor) {
  ScanGeometry geometry;
  geometry.num_beams = sensor.num_beams();
  geometry.first_rad = -0.5 * sensor.fov_rad;
  geometry.step_rad = sensor.step_rad;
  geometry.min_range_m = sensor.min_range_m;
  geometry.max_range_m = sensor.range_limit_m();
  geometry.timing.num_rotations = sensor.num_rotations();
  geometry.timing.rotation_s = sensor.rotation_s;
  geometry.timing.step_s = sensor.beam_period_s();
  return geometry;
}

Spot spot_of(const SensorOptions& sensor) {
  const double scale = sensor.effects.spot;
  return {scale * sensor.spot.diameter_m, scale * sensor.spot.divergence_rad, sensor.spot.num_rays};
}

bool moves(const World& world) {
  return !world.walkers.empty() || !world.robot.drive.empty();
}

std::vector<Material> materials_of(const Engine& engine) {
  std::vector<Material> materials;
  for (const SliceObject& object : engine.objects()) materials.push_back(object.material);
  return materials;
}

/// Beams that are cast together, as if all were measured at one time.
struct Piece {
  BeamSubset beams;
  double offset_s;  ///< after the scan's time
};

// However slow the mirror, so many beams of a rotation need no times of their own.
constexpr int kMaxSectors = 256;

// How many pieces of a rotation are cast, each at its own time.
int num_sectors_of(const SensorOptions& sensor, int num_beams) {
  const double sweep_s = num_beams * sensor.beam_period_s();
  const double num_sectors = std::ceil(sweep_s / sensor.max_sector_s);
  return static_cast<int>(
      std::clamp(num_sectors, 1.0, static_cast<double>(std::min(num_beams, kMaxSectors))));
}

// In the order of time. In a world that stands still one piece says all.
std::vector<Piece> pieces_of(const SensorOptions& sensor, const ScanGeometry& geometry, bool world_moves) {
  if (!world_moves) return {{{0, 1, geometry.num_beams}, 0.0}};
  const BeamTiming& timing = geometry.timing;
  std::vector<Piece> pieces;
  for (int rotation = 0; rotation < timing.num_rotations; ++rotation) {
    const int num_beams = (geometry.num_beams - rotation + timing.num_rotations - 1) / timing.num_rotations;
    const int num_sectors = num_sectors_of(sensor, num_beams);
    for (int sector = 0; sector < num_sectors; ++sector) {
      const int first = sector * num_beams / num_sectors;
      const int behind = (sector + 1) * num_beams / num_sectors;
      if (first == behind) continue;
      const double middle = 0.5 * (first + behind - 1);
      pieces.push_back({{rotation + first * timing.num_rotations, timing.num_rotations, behind - first},
                        rotation * timing.rotation_s + middle * timing.step_s});
    }
  }
  return pieces;
}

/// Drives a robot after the legs that it detects.
class Pilot {
 public:
  Pilot(const Robot& robot, const SimulationOptions& options)
      : robot_(robot), period_s_(options.lms.scan_period_s), detector_(options.detector) {}

  /// Commands the robot from the next scan's time on.
  void see(const LaserScan& scan, const Pose2& X_WR, DrivePlan& drive) {
    const double next_s = static_cast<double>(scan.index + 1) * period_s_;
    const FollowLegs* task = drive.following_at(next_s);
    if (task != task_) follower_.reset();
    task_ = task;
    if (task == nullptr) return;
    if (!follower_) follower_.emplace(robot_, *task);
    drive.command(next_s, follower_->update({scan.time_s, X_WR, detector_.detect(scan).legs, period_s_}));
  }

 private:
  Robot robot_;
  double period_s_;
  FeatureDetector detector_;
  const FollowLegs* task_ = nullptr;
  std::optional<LegFollower> follower_;
};

bool follows_legs(const Robot& robot) {
  return std::any_of(robot.drive.begin(), robot.drive.end(),
                     [](const DriveStep& step) { return std::holds_alternative<FollowLegs>(step); });
}

}  // namespace

struct SimulatedLms::Impl {
  Impl(World&& description, const SimulationOptions& given);
  void advance_to(double time_s);
  void cast_piece(std::size_t piece);
  void begin(double time_s);

  SimulationOptions options;
  World world;
  std::unique_ptr<Engine> engine;
  ScanGeometry geometry;
  SensorModel model;
  std::vector<Piece> pieces;
  std::vector<SectorCuller> cullers;  ///< one for each piece
  std::vector<RayCaster> axes;        ///< likewise
  std::vector<SpotCaster> spots;      ///< likewise; none where beams are rays
  IdealReturns returns;
  TruthMaker truth_maker;
  VisibilityClassifier visibility;
  std::int64_t num_scans;
  std::int64_t next_scan = 0;
  WorldState state;
  std::optional<CollisionWatch> watch;  ///< only where something moves
  double next_look_s = 0.0;
  std::optional<Pilot> pilot;  ///< only where legs are followed
};

SimulatedLms::Impl::Impl(World&& description, const SimulationOptions& given)
    : options(validated(given)),
      world(std::move(description)),
      engine(make_engine(world, options.backend)),
      geometry(geometry_of(options.lms)),
      model(options.lms, options.seed, materials_of(*engine)),
      pieces(pieces_of(options.lms, geometry, moves(world))),
      truth_maker(engine->objects(), geometry.num_beams),
      // The slack keeps 0.3 s at 0.1 s from having a fourth scan: 0.3 / 0.1 is a little less than 3.
      num_scans(static_cast<std::int64_t>(std::ceil(options.duration_s / options.lms.scan_period_s - 1e-9))),
      state(engine->state()) {
  if (moves(world)) watch.emplace(world);
  if (follows_legs(world.robot)) pilot.emplace(world.robot, options);
  const bool has_spot = options.lms.spot_diameter_m(1.0) > 0.0;
  const Spot spot = has_spot ? spot_of(options.lms) : Spot{};
  for (const Piece& piece : pieces) {
    cullers.emplace_back(geometry, piece.beams, spot);
    axes.emplace_back(geometry, piece.beams).reserve(engine->objects().size());
    if (has_spot) spots.emplace_back(geometry, piece.beams, spot).reserve(engine->objects().size());
  }
  if (!has_spot) return;
  const auto num_beams = static_cast<std::size_t>(geometry.num_beams);
  returns.split_spots.reserve(num_beams);
  returns.spot_returns.reserve(num_beams * options.lms.spot.num_rays);
}

// Looks in between too: from one scan to the next somebody may pass through a wall.
void SimulatedLms::Impl::advance_to(double time_s) {
  for (; watch && next_look_s < time_s; next_look_s += kBetweenLooks_s) {
    engine->advance_to(next_look_s);
    watch->look(engine->state());
  }
  engine->advance_to(time_s);
}

void SimulatedLms::Impl::begin(double time_s) {
  advance_to(time_s);
  state = engine->state();
  truth_maker.begin(engine->state().X_WR * world.robot.X_RS);
  returns.reset(geometry.num_beams);
}

void SimulatedLms::Impl::cast_piece(std::size_t piece) {
  const PlanarSlice& slice = engine->slice();
  const Pose2 X_LS = engine->sensor_in_plane();
  const PlanarSlice& in_sector = cullers[piece].cull(slice, X_LS);
  RayCaster& caster = axes[piece];
  caster.cast(in_sector, X_LS);
  truth_maker.add_piece(pieces[piece].beams, slice, X_LS);
  returns.take_axes(caster);
  if (!spots.empty()) spots[piece].cast(in_sector, X_LS, caster, returns);
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
  s.begin(time_s);
  for (std::size_t piece = 0; piece < s.pieces.size(); ++piece) {
    if (s.pieces[piece].offset_s > 0.0) s.advance_to(time_s + s.pieces[piece].offset_s);
    s.cast_piece(piece);
  }
  s.truth_maker.finish(s.returns, s.geometry.max_range_m);
  s.model.measure(s.returns, s.next_scan, scan.range_m);
  scan.index = s.next_scan;
  scan.time_s = time_s;
  scan.geometry = s.geometry;
  scan.X_OR.reset();
  scan.source.clear();
  s.visibility.classify(s.truth_maker.truth(), scan);
  if (s.pilot) s.pilot->see(scan, s.state.X_WR, s.engine->drive());
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

const std::vector<Collision>& SimulatedLms::collisions() const {
  static const std::vector<Collision> none;
  return impl_->watch ? impl_->watch->collisions() : none;
}

}  // namespace scanbed::sim
