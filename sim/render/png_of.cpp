// SPDX-License-Identifier: MIT
#include <png.h>

#include <cstddef>
#include <string>

#include "core/errors/ensure.hpp"
#include "sim/render/scene_picture.hpp"

namespace scanbed::sim {

std::string png_of(const Image& image) {
  SCANBED_ENSURE(image.width_px > 0 && image.height_px > 0);
  SCANBED_ENSURE(image.rgb.size() == 3 * static_cast<std::size_t>(image.width_px) * image.height_px);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width_px);
  png.height = static_cast<png_uint_32>(image.height_px);
  png.format = PNG_FORMAT_RGB;
  png.flags = PNG_IMAGE_FLAG_FAST;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');
  png_alloc_size_t num_bytes = bytes.size();
  const int done = png_image_write_to_memory(&png, bytes.data(), &num_bytes, 0, image.rgb.data(), 0, nullptr);
  SCANBED_ENSURE(done != 0);
  bytes.resize(num_bytes);
  return bytes;
}

}  // namespace scanbed::sim
