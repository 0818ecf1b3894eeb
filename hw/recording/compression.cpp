// SPDX-License-Identifier: MIT
#include "hw/recording/compression.hpp"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <utility>

#include "core/errors/ensure.hpp"
#include "core/errors/input_error.hpp"

namespace scanbed::hw {
namespace {

constexpr std::size_t kOutputBlock = std::size_t{1} << 18;

/// Takes unpacked bytes as they come, one more than claimed at most.
class Output {
 public:
  Output(std::string_view name, std::uint64_t num_bytes) : name_(name), most_(num_bytes) {
    if (num_bytes > kMostUnpacked) {
      throw InputError(name_ + " data claims to unpack to " + std::to_string(num_bytes) +
                       " bytes, more than " + std::to_string(kMostUnpacked));
    }
  }

  /// Room for the next bytes, never empty.
  char* room() {
    const std::size_t num_wanted = std::min(used_ + kOutputBlock, static_cast<std::size_t>(most_) + 1);
    if (num_wanted > bytes_.size()) bytes_.resize(num_wanted);
    return bytes_.data() + used_;
  }
  std::size_t num_room() const { return bytes_.size() - used_; }

  void use(std::size_t num) {
    used_ += num;
    if (used_ <= most_) return;
    throw InputError(name_ + " data unpacks to more than the " + std::to_string(most_) + " bytes it claims");
  }

  [[noreturn]] void damaged() const { throw InputError(name_ + " data is damaged or cut off"); }

  std::string take() {
    if (used_ != most_) {
      throw InputError(name_ + " data unpacks to " + std::to_string(used_) + " bytes in place of the " +
                       std::to_string(most_) + " it claims");
    }
    bytes_.resize(used_);
    return std::move(bytes_);
  }

 private:
  std::string name_;
  std::uint64_t most_;
  std::string bytes_;
  std::size_t used_ = 0;
};

std::string unpack_bzip2(std::string_view packed, Output output) {
  struct Stream : bz_stream {
    Stream() : bz_stream{} { SCANBED_ENSURE(BZ2_bzDecompressInit(this, 0, 0) == BZ_OK); }
    ~Stream() { BZ2_bzDecompressEnd(this); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;
  } stream;
  // bzlib does not write through its input.
  stream.next_in = const_cast<char*>(packed.data());
  stream.avail_in = static_cast<unsigned>(packed.size());
  for (int status = BZ_OK; status != BZ_STREAM_END;) {
    stream.next_out = output.room();
    const std::size_t num_room = output.num_room();
    stream.avail_out = static_cast<unsigned>(num_room);
    status = BZ2_bzDecompress(&stream);
    const std::size_t num_written = num_room - stream.avail_out;
    if (status != BZ_OK && status != BZ_STREAM_END) output.damaged();
    if (status == BZ_OK && stream.avail_in == 0 && num_written == 0) output.damaged();
    output.use(num_written);
  }
  if (stream.avail_in != 0) output.damaged();
  return output.take();
}

std::string unpack_lz4(std::string_view packed, Output output) {
  struct Context {
    LZ4F_dctx* get = nullptr;
    Context() { SCANBED_ENSURE(LZ4F_isError(LZ4F_createDecompressionContext(&get, LZ4F_VERSION)) == 0U); }
    ~Context() { LZ4F_freeDecompressionContext(get); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
  } context;
  for (std::size_t hint = 1; hint != 0;) {
    char* const room = output.room();
    std::size_t num_written = output.num_room();
    std::size_t num_read = packed.size();
    hint = LZ4F_decompress(context.get, room, &num_written, packed.data(), &num_read, nullptr);
    if (LZ4F_isError(hint) != 0U || (num_read == 0 && num_written == 0 && hint != 0)) output.damaged();
    packed.remove_prefix(num_read);
    output.use(num_written);
  }
  if (!packed.empty()) output.damaged();
  return output.take();
}

std::string unpack_zstd(std::string_view packed, Output output) {
  struct Context {
    ZSTD_DCtx* get = ZSTD_createDCtx();
    Context() = default;
    ~Context() { ZSTD_freeDCtx(get); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
  } context;
  SCANBED_ENSURE(context.get != nullptr);
  // 2^27: a frame may not ask for a window, and so for memory, of more than 128 MiB.
  SCANBED_ENSURE(ZSTD_isError(ZSTD_DCtx_setParameter(context.get, ZSTD_d_windowLogMax, 27)) == 0U);
  ZSTD_inBuffer in = {packed.data(), packed.size(), 0};
  for (std::size_t hint = 1; hint != 0;) {
    char* const room = output.room();
    ZSTD_outBuffer out = {room, output.num_room(), 0};
    const std::size_t was_at = in.pos;
    hint = ZSTD_decompressStream(context.get, &out, &in);
    if (ZSTD_isError(hint) != 0U || (in.pos == was_at && out.pos == 0 && hint != 0)) output.damaged();
    output.use(out.pos);
  }
  if (in.pos != in.size) output.damaged();
  return output.take();
}

}  // namespace

std::optional<Packing> packing_of_name(std::string_view name) {
  if (name.empty() || name == "none") return Packing::kNone;
  if (name == "bz2") return Packing::kBzip2;
  if (name == "lz4") return Packing::kLz4;
  if (name == "zstd") return Packing::kZstd;
  return std::nullopt;
}

std::string unpack_chunk(std::string_view packed, Packing packing, std::uint64_t num_bytes) {
  switch (packing) {
    case Packing::kBzip2:
      return unpack_bzip2(packed, Output("bz2", num_bytes));
    case Packing::kLz4:
      return unpack_lz4(packed, Output("lz4", num_bytes));
    case Packing::kZstd:
      return unpack_zstd(packed, Output("zstd", num_bytes));
    case Packing::kNone:
      break;
  }
  if (packed.size() == num_bytes) return std::string(packed);
  throw InputError("a chunk of " + std::to_string(packed.size()) + " bytes claims to be " +
                   std::to_string(num_bytes));
}

std::string pack_lz4(std::string_view bytes) {
  LZ4F_preferences_t preferences = {};
  preferences.frameInfo.blockSizeID = LZ4F_max1MB;
  preferences.frameInfo.blockMode = LZ4F_blockIndependent;
  preferences.frameInfo.contentChecksumFlag = LZ4F_contentChecksumEnabled;
  std::string packed(LZ4F_compressFrameBound(bytes.size(), &preferences), '\0');
  const std::size_t num_packed =
      LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), &preferences);
  SCANBED_ENSURE(LZ4F_isError(num_packed) == 0U);
  packed.resize(num_packed);
  return packed;
}

}  // namespace scanbed::hw
