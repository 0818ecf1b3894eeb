// SPDX-License-Identifier: MIT
#include "sim/render/gl_context.hpp"

#include <GL/osmesa.h>

#include "core/errors/sensor_fault.hpp"

namespace scanbed::sim {
namespace {

constexpr int kWindow_px = 16;

[[noreturn]] void fail(const char* what) {
  throw SensorFault(SensorFault::Kind::kSimulator, std::string("off-screen OpenGL: ") + what);
}

}  // namespace

void GlContext::Destroyer::operator()(void* context) const {
  OSMesaDestroyContext(static_cast<OSMesaContext>(context));
}

GlContext::GlContext() : window_(static_cast<std::size_t>(kWindow_px) * kWindow_px) {
  constexpr int kDepthBits = 24;
  constexpr int kStencilBits = 8;
  context_.reset(OSMesaCreateContextExt(OSMESA_RGBA, kDepthBits, kStencilBits, 0, nullptr));
  if (!context_) fail("OSMesa gives no context");
  make_current();
}

GlContext::~GlContext() = default;

void GlContext::make_current() {
  const auto context = static_cast<OSMesaContext>(context_.get());
  if (OSMesaGetCurrentContext() == context) return;
  if (!OSMesaMakeCurrent(context, window_.data(), GL_UNSIGNED_BYTE, kWindow_px, kWindow_px)) {
    fail("OSMesa does not take its context into use");
  }
}

}  // namespace scanbed::sim
