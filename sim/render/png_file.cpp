// SPDX-License-Identifier: MIT
#include <png.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "core/errors/ensure.hpp"
#include "core/errors/input_error.hpp"
#include "sim/render/scene_picture.hpp"

namespace scanbed::sim {
namespace {

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using FilePtr = std::unique_ptr<std::FILE, FileCloser>;

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw InputError("picture " + path.string() +
                   ": cannot be written: " + std::generic_category().message(error) +
                   "; needs a directory that exists and may be written to");
}

std::vector<unsigned char> encoded(const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width_px);
  png.height = static_cast<png_uint_32>(image.height_px);
  png.format = PNG_FORMAT_RGB;
  png.flags = PNG_IMAGE_FLAG_FAST;
  std::vector<unsigned char> bytes(PNG_IMAGE_PNG_SIZE_MAX(png));
  png_alloc_size_t num_bytes = bytes.size();
  const int done = png_image_write_to_memory(&png, bytes.data(), &num_bytes, 0, image.rgb.data(), 0, nullptr);
  SCANBED_ENSURE(done != 0);
  bytes.resize(num_bytes);
  return bytes;
}

/// A file beside the one that is meant; gone again unless it was renamed.
class PartFile {
 public:
  explicit PartFile(const std::filesystem::path& target) : target_(target) {
    constexpr int kMaxTries = 100;  // names that a process killed halfway left behind
    for (int i = 0; i < kMaxTries && !file_; ++i) {
      path_ = target.string() + ".part" + std::to_string(i);
      file_.reset(std::fopen(path_.c_str(), "wbx"));
      if (!file_ && errno != EEXIST) break;
    }
    if (!file_) fail(target_, errno);
  }
  ~PartFile() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove(path_, ignored);
  }
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  void write(const std::vector<unsigned char>& bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) fail(target_, errno);
  }

  void move_to_target() {
    if (std::fclose(file_.release()) != 0) fail(target_, errno);
    std::error_code error;
    std::filesystem::rename(path_, target_, error);
    if (error) fail(target_, error.value());
    path_.clear();
  }

 private:
  std::filesystem::path target_;
  std::filesystem::path path_;
  FilePtr file_;
};

}  // namespace

void write_png(const Image& image, const std::filesystem::path& path) {
  SCANBED_ENSURE(image.width_px > 0 && image.height_px > 0);
  SCANBED_ENSURE(image.rgb.size() == 3 * static_cast<std::size_t>(image.width_px) * image.height_px);
  PartFile part(path);
  part.write(encoded(image));
  part.move_to_target();
}

}  // namespace scanbed::sim
