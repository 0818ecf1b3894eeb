// SPDX-License-Identifier: MIT
#include "hw/recording/byte_stream.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/errors/ensure.hpp"
#include "core/errors/input_error.hpp"
#include "core/errors/sensor_fault.hpp"
#include "hw/serial/file_descriptor.hpp"
#include "hw/serial/steady_clock.hpp"
#include "hw/serial/stop_signal.hpp"

namespace scanbed::hw {
namespace {

std::string reason(int error) {
  return std::generic_category().message(error);
}

class FileBytes final : public ByteStream {
 public:
  // Without waiting for the writer of a FIFO, which could not be interrupted.
  FileBytes(const std::filesystem::path& path, std::function<bool()> is_interrupted)
      : name_(path.string()),
        file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)),
        is_interrupted_(std::move(is_interrupted)) {
    if (!file_.is_open()) throw InputError(name_ + ": cannot be opened: " + reason(errno));
  }

  std::size_t read(std::span<char> out) override {
    for (;;) {
      while (!wait_until(steady_now_s() + kBetweenLooks_s)) continue;
      const ssize_t num_read = ::read(file_.get(), out.data(), out.size());
      if (num_read >= 0) return static_cast<std::size_t>(num_read);
      if (errno == EINTR || errno == EAGAIN) continue;
      throw SensorFault(SensorFault::Kind::kDisconnected, name_ + ": reading failed: " + reason(errno));
    }
  }

  /// A file on a disk is always ready.
  bool wait_until(double deadline_s) override {
    pollfd polled = {file_.get(), POLLIN, 0};
    for (;;) {
      if (is_interrupted_ && is_interrupted_()) throw Stopped{};
      const double left_s = std::clamp(deadline_s - steady_now_s(), 0.0, kBetweenLooks_s);
      const int num_ready = ::poll(&polled, 1, static_cast<int>(std::ceil(left_s * 1e3)));
      if (num_ready > 0) return true;
      if (num_ready < 0 && errno != EINTR) return true;  // the read that follows says what is wrong
      if (steady_now_s() >= deadline_s) return false;
    }
  }

  /// Refuses what cannot hold a recording. A pipe has no size: whether it is empty shows when it is read.
  void check_kind() const {
    struct stat status = {};
    if (::fstat(file_.get(), &status) != 0) throw InputError(name_ + ": " + reason(errno));
    if (S_ISDIR(status.st_mode)) throw InputError(name_ + ": is a folder; expected a file");
    if (S_ISREG(status.st_mode) && status.st_size == 0) throw InputError(name_ + ": is empty");
  }

 private:
  static constexpr double kBetweenLooks_s = 0.1;  // at what may interrupt

  std::string name_;
  FileDescriptor file_;
  std::function<bool()> is_interrupted_;
};

class MemoryBytes final : public ByteStream {
 public:
  explicit MemoryBytes(std::string bytes) : bytes_(std::move(bytes)) {}

  std::size_t read(std::span<char> out) override {
    const std::size_t num_read = std::min(out.size(), bytes_.size() - position_);
    std::copy_n(bytes_.data() + position_, num_read, out.data());
    position_ += num_read;
    return num_read;
  }

 private:
  std::string bytes_;
  std::size_t position_ = 0;
};

constexpr std::string_view kGzipMagic = "\x1f\x8b";

/// Passes bytes on, through zlib where they are packed.
class UnpackedBytes final : public ByteStream {
 public:
  explicit UnpackedBytes(std::unique_ptr<ByteStream> source) : source_(std::move(source)) {
    // 16 makes zlib expect gzip's header and check its trailer.
    SCANBED_ENSURE(inflateInit2(&zlib_, MAX_WBITS + 16) == Z_OK);
    // Both bytes of the magic, even from a pipe that gives one at a time.
    while (num_input_ < kGzipMagic.size() && fetch_more()) continue;
    packed_ = input().starts_with(kGzipMagic);
    done_ = num_input_ == 0;
  }
  ~UnpackedBytes() override { inflateEnd(&zlib_); }

  std::size_t read(std::span<char> out) override { return packed_ ? inflate_into(out) : copy_into(out); }
  bool wait_until(double deadline_s) override {
    return num_input_ > 0 || done_ || source_->wait_until(deadline_s);
  }
  StreamEnd end() const override { return end_; }

 private:
  std::string_view input() const { return {input_.data() + first_input_, num_input_}; }

  /// Appends to the input; false at the source's end.
  bool fetch_more() {
    if (first_input_ > 0) {
      std::copy_n(input_.data() + first_input_, num_input_, input_.data());
      first_input_ = 0;
    }
    const std::size_t num_read = source_->read(std::span(input_).subspan(num_input_));
    num_input_ += num_read;
    return num_read > 0;
  }

  void consume(std::size_t num) {
    first_input_ += num;
    num_input_ -= num;
  }

  std::size_t copy_into(std::span<char> out) {
    if (num_input_ == 0) return source_->read(out);
    const std::size_t num = std::min(out.size(), num_input_);
    std::copy_n(input().data(), num, out.data());
    consume(num);
    return num;
  }

  std::size_t finish(StreamEnd end) {
    done_ = true;
    end_ = end;
    return 0;
  }

  std::size_t inflate_into(std::span<char> out) {
    while (!done_) {
      if (num_input_ == 0 && !fetch_more()) {
        return finish(between_members_ ? StreamEnd::kClean : StreamEnd::kCutOff);
      }
      if (between_members_ && !next_member()) continue;
      const std::size_t num_written = inflate_some(out);
      if (num_written > 0) return num_written;
    }
    return 0;
  }

  /// One call of zlib; returns how many bytes it wrote and notes the end of a member or of the data.
  std::size_t inflate_some(std::span<char> out) {
    zlib_.next_in = reinterpret_cast<Bytef*>(input_.data() + first_input_);
    zlib_.avail_in = static_cast<uInt>(num_input_);
    zlib_.next_out = reinterpret_cast<Bytef*>(out.data());
    zlib_.avail_out = static_cast<uInt>(out.size());
    const int status = inflate(&zlib_, Z_NO_FLUSH);
    consume(num_input_ - zlib_.avail_in);
    if (status == Z_STREAM_END) {
      between_members_ = true;
    } else if (status != Z_OK && status != Z_BUF_ERROR) {
      finish(StreamEnd::kDamaged);
    }
    return out.size() - zlib_.avail_out;
  }

  /// After a member: skips padding, and starts on the next member. False where there is none yet.
  bool next_member() {
    const std::size_t first = input().find_first_not_of('\0');
    consume(first == std::string_view::npos ? num_input_ : first);
    if (num_input_ == 0) return false;
    SCANBED_ENSURE(inflateReset(&zlib_) == Z_OK);
    between_members_ = false;
    return true;
  }

  std::unique_ptr<ByteStream> source_;
  z_stream zlib_ = {};
  std::array<char, 1 << 16> input_ = {};
  std::size_t first_input_ = 0;
  std::size_t num_input_ = 0;
  bool packed_ = false;
  bool between_members_ = false;
  bool done_ = false;
  StreamEnd end_ = StreamEnd::kClean;
};

}  // namespace

void need_clean_end(StreamEnd end, const std::string& name, std::int64_t num_scans) {
  if (end == StreamEnd::kClean) return;
  throw InputError(name + ": compressed data is " + (end == StreamEnd::kCutOff ? "cut off" : "damaged") +
                   " after " + std::to_string(num_scans) + " scans");
}

std::unique_ptr<ByteStream> open_file(const std::filesystem::path& path,
                                      std::function<bool()> is_interrupted) {
  auto file = std::make_unique<FileBytes>(path, std::move(is_interrupted));
  file->check_kind();
  return file;
}

std::unique_ptr<ByteStream> from_memory(std::string bytes) {
  return std::make_unique<MemoryBytes>(std::move(bytes));
}

std::unique_ptr<ByteStream> unpack(std::unique_ptr<ByteStream> packed) {
  return std::make_unique<UnpackedBytes>(std::move(packed));
}

}  // namespace scanbed::hw
