// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace scanbed::hw {

/// How a stream of bytes came to its end.
enum class StreamEnd {
  kClean,    ///< everything was read
  kCutOff,   ///< packed data stops in the middle
  kDamaged,  ///< packed data does not unpack, or its checksum is wrong
};

/// @throws InputError unless the end is clean; it says how many scans of the recording `name` came before.
void need_clean_end(StreamEnd end, const std::string& name, std::int64_t num_scans);

/// Bytes that are read once, front to back.
class ByteStream {
 public:
  ByteStream() = default;
  ByteStream(const ByteStream&) = delete;
  ByteStream& operator=(const ByteStream&) = delete;
  virtual ~ByteStream() = default;

  /// Fills the front of `out` (not empty) and returns how many bytes it wrote; 0 only at the end, and so it
  /// stays.
  /// @throws SensorFault of kind kDisconnected where the operating system fails to read.
  ///         Stopped where it is interrupted while it waits for bytes to come.
  virtual std::size_t read(std::span<char> out) = 0;

  /// Waits until read() has something to give or the stream is at its end, but no longer than to `deadline_s`
  /// of steady_now_s(): false where neither has come by then. Of a packed stream it says that there is
  /// something to unpack. Streams whose bytes are all there never wait.
  virtual bool wait_until(double /*deadline_s*/) { return true; }

  /// How the stream ended, once read() has returned 0.
  virtual StreamEnd end() const { return StreamEnd::kClean; }
};

/// Bytes of a file or of anything else that open(2) opens. A FIFO need not have a writer yet.
/// @param is_interrupted  asked ten times a second where bytes are waited for, as of a pipe; may be empty.
/// @throws InputError where the file is missing, may not be read, is a folder, or is empty.
std::unique_ptr<ByteStream> open_file(const std::filesystem::path& path,
                                      std::function<bool()> is_interrupted = {});

/// Bytes that are in memory already.
std::unique_ptr<ByteStream> from_memory(std::string bytes);

/// The bytes of `packed`, unpacked where they begin with the two magic bytes of gzip, else as they are. Reads
/// several gzip members in a row, and zero bytes after the last one (padding of tapes and disks), as gzip(1)
/// does.
/// @par Source RFC 1952, section 2.3; inflation by zlib.
std::unique_ptr<ByteStream> unpack(std::unique_ptr<ByteStream> packed);

}  // namespace scanbed::hw
