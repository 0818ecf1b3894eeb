// SPDX-License-Identifier: MIT
#include "sim/engine/make_engine.hpp"

#include <string>

#include "core/errors/input_error.hpp"
#include "sim/planar/planar_engine.hpp"
#include "sim/spatial/spatial_engine.hpp"

namespace scanbed::sim {

std::string_view to_string(Backend backend) {
  return backend == Backend::kPlanar ? "planar" : "spatial";
}

Backend parse_backend(std::string_view name) {
  for (const Backend backend : {Backend::kPlanar, Backend::kSpatial}) {
    if (name == to_string(backend)) return backend;
  }
  throw InputError("backend: '" + std::string(name) + "' is not known; allowed: planar, spatial");
}

std::unique_ptr<Engine> make_engine(const World& world, Backend backend) {
  if (backend == Backend::kSpatial) return std::make_unique<SpatialEngine>(world);
  return std::make_unique<PlanarEngine>(world);
}

}  // namespace scanbed::sim
