// SPDX-License-Identifier: MIT
// Any bytes are an image whose outlines lie within it, or an InputError of one line.
#include <cstddef>
#include <string_view>

#include "core/errors/ensure.hpp"
#include "core/errors/input_error.hpp"
#include "sim/map/grey_image.hpp"
#include "sim/map/trace_outlines.hpp"
#include "tests/fuzz/fuzz_target.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const scanbed::sim::GreyImage image =
        scanbed::sim::decode_grey_image(bytes, "input", {.max_bytes = 1 << 20, .max_pixels = 1 << 16});
    scanbed::sim::OccupiedCells grid{image.width_px, image.height_px, {}};
    for (const std::uint8_t shade : image.shades) grid.cells.push_back(shade < 128);
    for (const scanbed::sim::Outline& outline : scanbed::sim::trace_outlines(grid, 10'000)) {
      SCANBED_ENSURE(outline.size() >= 3);
      for (const Eigen::Vector2d& corner : outline) {
        SCANBED_ENSURE(corner.x() >= 0.0 && corner.x() <= image.width_px);
        SCANBED_ENSURE(corner.y() >= 0.0 && corner.y() <= image.height_px);
      }
    }
  } catch (const scanbed::InputError& error) {
    SCANBED_ENSURE(std::string_view(error.what()).find('\n') == std::string_view::npos);
  }
  return 0;
}
