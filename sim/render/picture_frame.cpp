// SPDX-License-Identifier: MIT
#include "sim/render/picture_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "core/errors/ensure.hpp"
#include "sim/render/feature_colors.hpp"

namespace scanbed::sim {
namespace {

const Rgba kBand{1.0, 1.0, 1.0, 0.86};
const Rgba kInk{0.10, 0.11, 0.13, 1.0};
const Rgba kGridInk{0.25, 0.27, 0.32, 0.16};

// In a picture of 720 rows.
constexpr double kCaptionHeight_px = 36.0;
constexpr double kLegendHeight_px = 34.0;

void fill_band(Canvas& canvas, double top_px, double bottom_px) {
  const double right_px = canvas.width_px();
  canvas.fill({{0.0, top_px}, {right_px, top_px}, {right_px, bottom_px}, {0.0, bottom_px}}, kBand);
}

std::string metres(double value_m) {
  std::ostringstream text;
  text << (std::abs(value_m) < 1e-9 ? 0.0 : value_m);
  return text.str();
}

std::string count(std::size_t number, const std::string& noun) {
  return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

void drop_last_character(std::string& utf8) {
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; };
  while (utf8.size() > 1 && continues(utf8.back())) utf8.pop_back();
  utf8.pop_back();
}

// A length on the floor in pixels, and where the floor's origin falls.
struct PlanGrid {
  explicit PlanGrid(const ViewCamera& camera)
      : px_per_m(camera.px_per_m(camera.X_WC.translation().z())),
        x_left_m(camera.X_WC.translation().x() - 0.5 * camera.width_px / px_per_m),
        y_top_m(camera.X_WC.translation().y() + 0.5 * camera.height_px / px_per_m) {}

  double column_px(double x_m) const { return (x_m - x_left_m) * px_per_m; }
  double row_px(double y_m) const { return (y_top_m - y_m) * px_per_m; }

  double px_per_m;
  double x_left_m;
  double y_top_m;
};

void draw_scale_bar(Canvas& canvas, double px_per_m, double bottom_px) {
  const double scale = picture_scale(canvas);
  const double length_m = round_step_m(60.0 * scale / px_per_m);
  const double right_px = canvas.width_px() - 22.0 * scale;
  const double left_px = right_px - length_m * px_per_m;
  const double tick_px = 4.0 * scale;
  canvas.stroke({{{left_px, bottom_px - tick_px}, {left_px, bottom_px + tick_px}},
                 {{left_px, bottom_px}, {right_px, bottom_px}},
                 {{right_px, bottom_px - tick_px}, {right_px, bottom_px + tick_px}}},
                {kInk, 2.0 * scale});
  const TextStyle style{kInk, 13.0 * scale};
  const std::string text = metres(length_m) + " m";
  canvas.text({left_px - 8.0 * scale - canvas.text_width_px(text, style), bottom_px + 4.5 * scale}, text,
              style);
}

}  // namespace

double round_step_m(double least_m) {
  SCANBED_ENSURE(least_m > 0.0 && std::isfinite(least_m));
  const double decade = std::pow(10.0, std::floor(std::log10(least_m)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * decade >= least_m) return digit * decade;
  }
  return 10.0 * decade;
}

double picture_scale(const Canvas& canvas) {
  return std::clamp(canvas.height_px() / 720.0, 0.6, 4.0);
}

Eigen::AlignedBox2d middle_of(const Canvas& canvas) {
  const double scale = picture_scale(canvas);
  return {Eigen::Vector2d(0.0, kCaptionHeight_px * scale),
          Eigen::Vector2d(canvas.width_px(), canvas.height_px() - kLegendHeight_px * scale)};
}

void draw_caption(Canvas& canvas, const std::string& caption) {
  if (caption.empty()) return;
  const double scale = picture_scale(canvas);
  const TextStyle style{kInk, 16.0 * scale, true};
  const double room_px = canvas.width_px() - 32.0 * scale;
  constexpr std::size_t kMaxBytes = 500;
  std::string kept = caption.substr(0, kMaxBytes);
  std::string shown = caption.size() > kMaxBytes ? kept + "..." : kept;
  while (!kept.empty() && canvas.text_width_px(shown, style) > room_px) {
    drop_last_character(kept);
    shown = kept + "...";
  }
  fill_band(canvas, 0.0, kCaptionHeight_px * scale);
  canvas.text({16.0 * scale, 24.0 * scale}, shown, style);
}

void draw_legend(Canvas& canvas, const Features& features, const std::string& note) {
  struct Entry {
    std::string text;
    Rgba color;
  };
  const std::array<Entry, 4> entries{{{count(features.lines.size(), "line"), kLineColor},
                                      {count(features.circles.size(), "circle"), kCircleColor},
                                      {count(features.legs.size(), "leg"), kLegColor},
                                      {"laser echo", kEchoColor}}};
  const double scale = picture_scale(canvas);
  const TextStyle style{kInk, 14.0 * scale};
  const double bottom_px = canvas.height_px();
  const double middle_px = bottom_px - 0.5 * kLegendHeight_px * scale;
  const double baseline_px = middle_px + 5.0 * scale;
  fill_band(canvas, bottom_px - kLegendHeight_px * scale, bottom_px);
  double x_px = 18.0 * scale;
  for (const Entry& entry : entries) {
    canvas.dots({{x_px, middle_px}}, 5.5 * scale, entry.color);
    x_px += 12.0 * scale;
    canvas.text({x_px, baseline_px}, entry.text, style);
    x_px += canvas.text_width_px(entry.text, style) + 24.0 * scale;
  }
  const double note_px = canvas.width_px() - 16.0 * scale - canvas.text_width_px(note, style);
  if (note_px > x_px) canvas.text({note_px, baseline_px}, note, style);
}

void draw_plan_scale(Canvas& canvas, const ViewCamera& camera) {
  const PlanGrid grid(camera);
  const double scale = picture_scale(canvas);
  const double width_px = canvas.width_px();
  const double height_px = canvas.height_px();
  const double step_m = round_step_m(34.0 * scale / grid.px_per_m);
  const TextStyle style{{0.30, 0.32, 0.37, 1.0}, 11.5 * scale};
  const double lowest_px = middle_of(canvas).max().y();
  const double highest_px = middle_of(canvas).min().y();

  std::vector<Canvas::Polyline> lines;
  const int num_columns = static_cast<int>(width_px / (step_m * grid.px_per_m));
  const double x0_m = step_m * std::ceil(grid.x_left_m / step_m);
  for (int i = 0; i <= num_columns; ++i) {
    const double column_px = grid.column_px(x0_m + i * step_m);
    const std::string text = metres(x0_m + i * step_m);
    const double text_width_px = canvas.text_width_px(text, style);
    const double text_px = column_px - 0.5 * text_width_px;
    const bool fits = text_px > 4.0 * scale && text_px + text_width_px < width_px - 4.0 * scale;
    lines.push_back({{column_px, highest_px}, {column_px, lowest_px}});
    if (fits) canvas.text({text_px, lowest_px - 6.0 * scale}, text, style);
  }
  const int num_rows = static_cast<int>(height_px / (step_m * grid.px_per_m));
  const double y0_m = step_m * std::floor(grid.y_top_m / step_m);
  for (int i = 0; i <= num_rows; ++i) {
    const double row_px = grid.row_px(y0_m - i * step_m);
    if (row_px > highest_px && row_px < lowest_px) lines.push_back({{0.0, row_px}, {width_px, row_px}});
    if (row_px > highest_px + 8.0 * scale && row_px < lowest_px - 22.0 * scale) {
      canvas.text({8.0 * scale, row_px + 4.0 * scale}, metres(y0_m - i * step_m), style);
    }
  }
  canvas.stroke(lines, {kGridInk, 1.0});
  draw_scale_bar(canvas, grid.px_per_m, height_px - 17.0 * scale);
}

}  // namespace scanbed::sim
