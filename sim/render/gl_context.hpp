// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace scanbed::sim {

/// An OpenGL context in memory (OSMesa): no display, no graphics card.
class GlContext {
 public:
  /// @throws SensorFault (kSimulator) where OSMesa gives none.
  GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;
  ~GlContext();

  /// Makes it the context of the calling thread; what draws calls this first, every time.
  /// @throws SensorFault (kSimulator) where OSMesa refuses.
  void make_current();

 private:
  struct Destroyer {
    void operator()(void* context) const;
  };
  std::unique_ptr<void, Destroyer> context_;
  std::vector<std::uint32_t> window_;  ///< OSMesa wants one; pictures are drawn into a framebuffer object
};

}  // namespace scanbed::sim
