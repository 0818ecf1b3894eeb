// SPDX-License-Identifier: MIT
// Ideal scans of a hall in space: the laser's plane cut out of the model and cast, upright and tilted, and,
// in the same run, one mj_ray for each beam.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "bench/support/hall_world.hpp"
#include "sim/planar/ray_caster.hpp"
#include "sim/spatial/laser_mount.hpp"
#include "sim/spatial/mjcf.hpp"
#include "sim/spatial/mujoco_model.hpp"
#include "sim/spatial/pose_actors.hpp"
#include "sim/spatial/spatial_engine.hpp"
#include "sim/spatial/spatial_slicer.hpp"
#include "sim/world/world_script.hpp"
#include "tests/support/mj_reference_caster.hpp"

namespace scanbed::sim {
namespace {

/// The benches' hall at time 0: 36 shapes at the laser's height, some 60 geoms.
struct Hall {
  explicit Hall(double pitch_rad = 0.0) : world(bench::hall_world()) {
    world.robot.laser_pitch_rad = pitch_rad;
    model = load_model(mjcf_of(world));
    data = make_data(*model);
    WorldScript(world).follow(0.0, state);
    ActorPoser(world, *model).put(state, *data);
    mj_kinematics(model.get(), data.get());
    plane = laser_plane(world.robot, state.X_WR);
  }

  World world;
  ModelPtr model;
  DataPtr data;
  WorldState state;
  LaserPlane plane;
};

void run_cut_and_cast(benchmark::State& state, const Hall& hall) {
  SpatialSlicer slicer(hall.world, *hall.model);
  PlanarSlice slice;
  RayCaster caster{ScanGeometry{}};
  while (state.KeepRunning()) {
    slicer.slice(*hall.data, hall.plane, hall.state, slice);
    caster.cast(slice, {});
    benchmark::DoNotOptimize(caster.ranges_m().data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * caster.num_beams());
}

void run_mj_ray(benchmark::State& state, const Hall& hall) {
  const test::MjReferenceCaster reference(*hall.model, *hall.data);
  const ScanGeometry geometry;
  std::vector<Eigen::Vector3d> directions;
  directions.reserve(geometry.num_beams);
  for (int i = 0; i < geometry.num_beams; ++i) {
    const double bearing_rad = geometry.bearing_rad(i);
    directions.emplace_back(hall.plane.R_WS *
                            Eigen::Vector3d(std::cos(bearing_rad), std::sin(bearing_rad), 0.0));
  }
  while (state.KeepRunning()) {
    for (const Eigen::Vector3d& u : directions) benchmark::DoNotOptimize(reference.cast(hall.plane.p_WS, u));
  }
  state.SetItemsProcessed(state.iterations() * geometry.num_beams);
}

void spatial_scan_of_the_hall(benchmark::State& state) {
  run_cut_and_cast(state, Hall());
}
BENCHMARK(spatial_scan_of_the_hall);

void mj_rays_in_the_hall(benchmark::State& state) {
  run_mj_ray(state, Hall());
}
BENCHMARK(mj_rays_in_the_hall);

void spatial_scan_of_the_hall_tilted(benchmark::State& state) {
  run_cut_and_cast(state, Hall(0.05));
}
BENCHMARK(spatial_scan_of_the_hall_tilted);

void mj_rays_in_the_hall_tilted(benchmark::State& state) {
  run_mj_ray(state, Hall(0.05));
}
BENCHMARK(mj_rays_in_the_hall_tilted);

// The walker moved on as well: gait, MuJoCo's kinematics, then the scan.
void spatial_engine_and_scan_of_the_hall(benchmark::State& state) {
  SpatialEngine engine(bench::hall_world());
  RayCaster caster{ScanGeometry{}};
  double time_s = 0.0;
  while (state.KeepRunning()) {
    engine.advance_to(time_s += 0.2);
    caster.cast(engine.slice(), engine.sensor_in_plane());
    benchmark::DoNotOptimize(caster.ranges_m().data());
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(spatial_engine_and_scan_of_the_hall);

}  // namespace
}  // namespace scanbed::sim

BENCHMARK_MAIN();
