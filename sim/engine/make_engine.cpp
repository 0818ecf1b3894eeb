// SPDX-License-Identifier: MIT
#include "sim/engine/make_engine.hpp"

#include <array>
#include <cstddef>

#include "sim/planar/planar_engine.hpp"
#include "sim/spatial/spatial_engine.hpp"

namespace scanbed::sim {

std::span<const std::string> backend_names() {
  static const std::array<std::string, 2> kNames = {"planar", "spatial"};
  return kNames;
}

const std::string& to_string(Backend backend) {
  return backend_names()[static_cast<std::size_t>(backend)];
}

std::unique_ptr<Engine> make_engine(const World& world, Backend backend) {
  if (backend == Backend::kSpatial) return std::make_unique<SpatialEngine>(world);
  return std::make_unique<PlanarEngine>(world);
}

}  // namespace scanbed::sim
