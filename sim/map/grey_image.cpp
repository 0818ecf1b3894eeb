// SPDX-License-Identifier: MIT
#include "sim/map/grey_image.hpp"

#include <png.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "core/errors/input_error.hpp"

namespace scanbed::sim {
namespace {

constexpr std::string_view kPngSignature("\x89PNG\r\n\x1a\n", 8);

[[noreturn]] void refuse(std::string_view name, const std::string& message) {
  throw InputError(std::string(name) + ": " + message);
}

void check_size(std::string_view name, std::size_t width, std::size_t height, const ImageLimits& limits) {
  // Both are less than 2^31, so their product fits.
  if (width == 0 || height == 0) refuse(name, "the image has no pixels");
  if (width * height <= limits.max_pixels) return;
  refuse(name, "the image is too large: " + std::to_string(width) + " x " + std::to_string(height) +
                   " pixels; allowed: " + std::to_string(limits.max_pixels) + " in all");
}

/// The header of a PGM, and its pixels where they are written as text: numbers and comments.
class PgmText {
 public:
  PgmText(std::string_view bytes, std::string_view name) : bytes_(bytes), name_(name) {}

  [[noreturn]] void refuse_here(const std::string& message) const {
    refuse(name_, "byte " + std::to_string(at_) + ": " + message);
  }

  unsigned number(unsigned least, unsigned greatest) {
    skip_space();
    const std::size_t begin = at_;
    unsigned value = 0;
    for (; at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9'; ++at_) {
      value = 10 * value + static_cast<unsigned>(bytes_[at_] - '0');
      if (value > greatest) break;
    }
    const bool is_number = at_ > begin && value >= least && value <= greatest;
    if (is_number) return value;
    at_ = begin;
    refuse_here(begin == bytes_.size() ? "the file is cut off"
                                       : "expected a number of [" + std::to_string(least) + ", " +
                                             std::to_string(greatest) + "]");
  }

  /// What lies behind the header and the one blank that ends it.
  std::string_view rest() {
    if (at_ == bytes_.size() || !is_space(bytes_[at_])) refuse_here("expected a blank before the pixels");
    ++at_;
    return bytes_.substr(at_);
  }

  void skip(std::size_t num_bytes) { at_ += num_bytes; }

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  void skip_space() {
    for (; at_ < bytes_.size(); ++at_) {
      if (bytes_[at_] == '#') at_ = std::min(bytes_.find('\n', at_), bytes_.size());
      if (at_ == bytes_.size() || !is_space(bytes_[at_])) return;
    }
  }

  std::string_view bytes_;
  std::string_view name_;
  std::size_t at_ = 0;
};

std::uint8_t shade_of(unsigned value, unsigned white) {
  return static_cast<std::uint8_t>((255 * value + white / 2) / white);
}

void read_raw_pixels(PgmText& text, unsigned white, GreyImage& image) {
  const std::string_view pixels = text.rest();
  const std::size_t bytes_each = white > 255 ? 2 : 1;
  if (pixels.size() / bytes_each < image.shades.size()) {
    text.skip(pixels.size());
    text.refuse_here("the file is cut off; expected " + std::to_string(image.shades.size()) + " pixels");
  }
  for (std::size_t i = 0; i < image.shades.size(); ++i) {
    unsigned value = 0;
    for (std::size_t k = 0; k < bytes_each; ++k) {
      value = 256 * value + static_cast<unsigned char>(pixels[i * bytes_each + k]);
    }
    image.shades[i] = shade_of(std::min(value, white), white);
  }
}

GreyImage decode_pgm(std::string_view bytes, std::string_view name, const ImageLimits& limits) {
  constexpr unsigned kMostPixels = 1'000'000;
  PgmText text(bytes, name);
  text.skip(2);
  GreyImage image;
  image.width_px = static_cast<int>(text.number(1, kMostPixels));
  image.height_px = static_cast<int>(text.number(1, kMostPixels));
  check_size(name, static_cast<std::size_t>(image.width_px), static_cast<std::size_t>(image.height_px),
             limits);
  const unsigned white = text.number(1, 65535);
  const bool is_text = bytes[1] == '2';
  const std::size_t num_pixels = image.index(0, image.height_px);
  // Each pixel takes a byte or more, so a short file cannot ask for much memory.
  if (num_pixels > bytes.size()) {
    text.skip(bytes.size());
    refuse(name, "byte " + std::to_string(bytes.size()) + ": the file is cut off; expected " +
                     std::to_string(num_pixels) + " pixels");
  }
  image.shades.resize(num_pixels);
  if (!is_text) {
    read_raw_pixels(text, white, image);
    return image;
  }
  for (std::uint8_t& shade : image.shades) shade = shade_of(text.number(0, white), white);
  return image;
}

/// Frees what libpng holds, whatever happens.
struct PngReader {
  PngReader() { png.version = PNG_IMAGE_VERSION; }
  ~PngReader() { png_image_free(&png); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  png_image png{};
};

GreyImage decode_png(std::string_view bytes, std::string_view name, const ImageLimits& limits) {
  PngReader reader;
  png_image& png = reader.png;
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) {
    refuse(name, std::string("not a readable PNG: ") + png.message);
  }
  check_size(name, png.width, png.height, limits);
  // Colours and depths as map_server's own reader sees them: without corrections for display.
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
  const bool has_alpha = (png.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  png.format = PNG_FORMAT_RGBA;
  std::vector<std::uint8_t> rgba(PNG_IMAGE_SIZE(png));
  GreyImage image{static_cast<int>(png.width), static_cast<int>(png.height), {}, {}};
  if (png_image_finish_read(&png, nullptr, rgba.data(), 0, nullptr) == 0) {
    refuse(name, std::string("not a readable PNG: ") + png.message);
  }
  const std::size_t num_pixels = image.index(0, image.height_px);
  image.shades.resize(num_pixels);
  image.is_clear.resize(has_alpha ? num_pixels : 0);
  for (std::size_t i = 0; i < num_pixels; ++i) {
    const std::uint8_t* pixel = &rgba[4 * i];
    image.shades[i] = static_cast<std::uint8_t>((pixel[0] + pixel[1] + pixel[2]) / 3);
    if (has_alpha) image.is_clear[i] = pixel[3] == 0;
  }
  return image;
}

}  // namespace

GreyImage decode_grey_image(std::string_view bytes, std::string_view name, const ImageLimits& limits) {
  if (bytes.size() > limits.max_bytes) {
    refuse(name, "file is too large; allowed: " + std::to_string(limits.max_bytes / 1024) + " KiB");
  }
  if (bytes.starts_with("P2") || bytes.starts_with("P5")) return decode_pgm(bytes, name, limits);
  if (bytes.starts_with(kPngSignature)) return decode_png(bytes, name, limits);
  refuse(name, "byte 0: no image that can be read; expected PGM (P2, P5) or PNG");
}

GreyImage read_grey_image(const std::filesystem::path& path, const ImageLimits& limits) {
  std::ifstream file(path, std::ios::binary);
  if (!file) refuse(path.string(), "cannot be read: " + std::generic_category().message(errno));
  // One byte more than allowed shows that there is more; only what is there takes memory.
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  std::string bytes;
  while (file && bytes.size() <= limits.max_bytes) {
    const std::size_t before = bytes.size();
    bytes.resize(before + kPiece);
    file.read(&bytes[before], kPiece);
    bytes.resize(before + static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) refuse(path.string(), "cannot be read to its end");
  return decode_grey_image(bytes, path.string(), limits);
}

}  // namespace scanbed::sim
