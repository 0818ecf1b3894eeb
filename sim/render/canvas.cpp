// SPDX-License-Identifier: MIT
#include "sim/render/canvas.hpp"

#include <cairo.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "core/errors/ensure.hpp"
#include "core/text/utf8.hpp"

namespace scanbed::sim {
namespace {

constexpr double kFullTurn_rad = 6.283185307179586;

// Cairo goes into an error state, and draws nothing more, once it meets bytes that are no UTF-8.
std::string printable(std::string_view text) {
  std::string clean;
  while (!text.empty()) {
    const auto lead = static_cast<unsigned char>(text.front());
    const std::size_t length = utf8_length(text);
    clean += length == 0 || lead < 0x20 || lead == 0x7f ? "?" : text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return clean;
}

void set_color(cairo_t* cairo, const Rgba& color) {
  cairo_set_source_rgba(cairo, color[0], color[1], color[2], color[3]);
}

void set_font(cairo_t* cairo, const TextStyle& style) {
  cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, style.size_px);
}

// Cairo counts in 24 bits before the point; what is farther out is far outside every picture.
double bounded(double value_px) {
  constexpr double kMax_px = 4e6;
  return std::clamp(value_px, -kMax_px, kMax_px);
}

void trace(cairo_t* cairo, const Canvas::Polyline& points_px) {
  for (std::size_t i = 0; i < points_px.size(); ++i) {
    const Eigen::Vector2d p(bounded(points_px[i].x()), bounded(points_px[i].y()));
    i == 0 ? cairo_move_to(cairo, p.x(), p.y()) : cairo_line_to(cairo, p.x(), p.y());
  }
}

struct SurfaceDestroyer {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct ContextDestroyer {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

}  // namespace

struct Canvas::Impl {
  Impl(int width_px, int height_px)
      : surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px)),
        context(cairo_create(surface.get())) {}

  unsigned char* row(int index) const {
    const std::ptrdiff_t stride = cairo_image_surface_get_stride(surface.get());
    return cairo_image_surface_get_data(surface.get()) + index * stride;
  }

  std::unique_ptr<cairo_surface_t, SurfaceDestroyer> surface;
  std::unique_ptr<cairo_t, ContextDestroyer> context;
};

Canvas::Canvas(const Image& background)
    : width_px_(background.width_px),
      height_px_(background.height_px),
      impl_(std::make_unique<Impl>(background.width_px, background.height_px)) {
  SCANBED_ENSURE(cairo_status(impl_->context.get()) == CAIRO_STATUS_SUCCESS);
  cairo_set_antialias(impl_->context.get(),
                      CAIRO_ANTIALIAS_FAST);  // half the cost, hardly a difference to see
  cairo_set_line_join(impl_->context.get(), CAIRO_LINE_JOIN_ROUND);
  const std::uint8_t* rgb = background.rgb.data();
  for (int row = 0; row < height_px_; ++row) {
    unsigned char* at = impl_->row(row);
    for (int column = 0; column < width_px_; ++column, rgb += 3, at += 4) {
      const std::uint32_t pixel = std::uint32_t{rgb[0]} << 16U | std::uint32_t{rgb[1]} << 8U | rgb[2];
      std::memcpy(at, &pixel, sizeof pixel);
    }
  }
  cairo_surface_mark_dirty(impl_->surface.get());
}

Canvas::~Canvas() = default;

void Canvas::stroke(const std::vector<Polyline>& lines, const Stroke& style) {
  cairo_new_path(impl_->context.get());
  for (const Polyline& line : lines) {
    if (line.size() >= 2) trace(impl_->context.get(), line);
  }
  set_color(impl_->context.get(), style.color);
  cairo_set_line_width(impl_->context.get(), style.width_px);
  cairo_set_line_cap(impl_->context.get(), style.round_ends ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  cairo_stroke(impl_->context.get());
}

void Canvas::fill(const Polyline& outline, const Rgba& color) {
  cairo_new_path(impl_->context.get());
  trace(impl_->context.get(), outline);
  cairo_close_path(impl_->context.get());
  set_color(impl_->context.get(), color);
  cairo_fill(impl_->context.get());
}

void Canvas::dots(const Polyline& centers, double radius_px, const Rgba& color) {
  set_color(impl_->context.get(), color);
  for (const Eigen::Vector2d& center : centers) {
    cairo_new_path(impl_->context.get());
    cairo_arc(impl_->context.get(), bounded(center.x()), bounded(center.y()), radius_px, 0.0, kFullTurn_rad);
    cairo_fill(impl_->context.get());
  }
}

void Canvas::text(const Eigen::Vector2d& at_px, const std::string& text, const TextStyle& style) {
  set_font(impl_->context.get(), style);
  set_color(impl_->context.get(), style.color);
  cairo_move_to(impl_->context.get(), at_px.x(), at_px.y());
  cairo_show_text(impl_->context.get(), printable(text).c_str());
}

double Canvas::text_width_px(const std::string& text, const TextStyle& style) {
  set_font(impl_->context.get(), style);
  cairo_text_extents_t extents{};
  cairo_text_extents(impl_->context.get(), printable(text).c_str(), &extents);
  return extents.x_advance;
}

Image Canvas::image() const {
  cairo_surface_flush(impl_->surface.get());
  Image result{width_px_, height_px_, {}};
  result.rgb.resize(3 * static_cast<std::size_t>(width_px_) * height_px_);
  std::uint8_t* rgb = result.rgb.data();
  for (int row = 0; row < height_px_; ++row) {
    unsigned char* at = impl_->row(row);
    for (int column = 0; column < width_px_; ++column, rgb += 3, at += 4) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, at, sizeof pixel);
      rgb[0] = static_cast<std::uint8_t>(pixel >> 16U);
      rgb[1] = static_cast<std::uint8_t>(pixel >> 8U);
      rgb[2] = static_cast<std::uint8_t>(pixel);
    }
  }
  return result;
}

}  // namespace scanbed::sim
