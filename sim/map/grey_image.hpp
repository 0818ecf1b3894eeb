// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace scanbed::sim {

/// A picture in shades of grey; row 0 is its top.
struct GreyImage {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> shades;  ///< row by row: 0 black, 255 white
  std::vector<bool> is_clear;        ///< fully transparent; empty where nothing is

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_px) +
           static_cast<std::size_t>(column);
  }
};

/// What an image may cost.
struct ImageLimits {
  std::size_t max_bytes = std::size_t{64} * 1024 * 1024;
  std::size_t max_pixels = std::size_t{4096} * 4096;
};

/// Decodes a PGM (P2 or P5, 8 or 16 bits) or a PNG, whichever its first bytes say. Colours become the mean of
/// their channels.
///
/// @param name  what messages call it.
/// @throws InputError "name: byte N: ..." (PGM) or "name: ..." (PNG) for what is damaged, cut off, of another
///                    format or beyond the limits. Sizes are checked before memory is taken.
GreyImage decode_grey_image(std::string_view bytes, std::string_view name, const ImageLimits& limits = {});

/// The same for a file. @throws InputError also where it cannot be read or is too large.
GreyImage read_grey_image(const std::filesystem::path& path, const ImageLimits& limits = {});

}  // namespace scanbed::sim
