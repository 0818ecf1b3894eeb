// SPDX-License-Identifier: MIT
#include "hw/recording/byte_sink.hpp"

#include <unistd.h>
#include <zlib.h>

#include <array>
#include <cerrno>
#include <utility>

#include "core/errors/ensure.hpp"

namespace scanbed::hw {
namespace {

class GzipSink final : public ByteSink {
 public:
  explicit GzipSink(std::unique_ptr<ByteSink> packed) : packed_(std::move(packed)) {
    // 16 makes zlib write gzip's header and trailer.
    SCANBED_ENSURE(deflateInit2(&zlib_, Z_DEFAULT_COMPRESSION, Z_DEFLATED, MAX_WBITS + 16, 8,
                                Z_DEFAULT_STRATEGY) == Z_OK);
  }
  ~GzipSink() override { deflateEnd(&zlib_); }

  void append(std::string_view bytes) override {
    num_held_ += bytes.size();
    const bool flushes = ++num_pieces_held_ >= kMostPiecesHeld || num_held_ >= kMostHeld;
    deflate_all(bytes, flushes ? Z_SYNC_FLUSH : Z_NO_FLUSH);
    if (!flushes) return;
    num_held_ = 0;
    num_pieces_held_ = 0;
  }

  void finish() override {
    deflate_all({}, Z_FINISH);
    packed_->finish();
  }

 private:
  static constexpr std::size_t kMostHeld = std::size_t{1} << 16;
  static constexpr int kMostPiecesHeld = 8;

  void deflate_all(std::string_view bytes, int flush) {
    // zlib does not write through its input, but says so in its types only when asked to.
    zlib_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.data()));
    zlib_.avail_in = static_cast<uInt>(bytes.size());
    do {
      zlib_.next_out = output_.data();
      zlib_.avail_out = static_cast<uInt>(output_.size());
      SCANBED_ENSURE(deflate(&zlib_, flush) != Z_STREAM_ERROR);
      const std::size_t num = output_.size() - zlib_.avail_out;
      if (num > 0) packed_->append({reinterpret_cast<const char*>(output_.data()), num});
    } while (zlib_.avail_out == 0);
  }

  std::unique_ptr<ByteSink> packed_;
  z_stream zlib_ = {};
  std::array<Bytef, 1 << 16> output_ = {};
  std::size_t num_held_ = 0;
  int num_pieces_held_ = 0;
};

}  // namespace

void FileSink::append(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t num_written = ::write(file_.descriptor(), bytes.data(), bytes.size());
    if (num_written < 0 && errno == EINTR) continue;
    if (num_written < 0) file_.fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(num_written));
  }
}

void FileSink::overwrite(std::uint64_t offset, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t num_written =
        ::pwrite(file_.descriptor(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (num_written < 0 && errno == EINTR) continue;
    if (num_written < 0) file_.fail(errno);
    bytes.remove_prefix(static_cast<std::size_t>(num_written));
    offset += static_cast<std::uint64_t>(num_written);
  }
}

std::unique_ptr<ByteSink> pack_gzip(std::unique_ptr<ByteSink> packed) {
  return std::make_unique<GzipSink>(std::move(packed));
}

}  // namespace scanbed::hw
