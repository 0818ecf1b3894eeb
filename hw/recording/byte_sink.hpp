// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace scanbed::hw {

/// A recording that could not be written: a full disk, a folder that is not there. The message names the
/// file.
class WriteFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Bytes that are written once, front to back.
class ByteSink {
 public:
  ByteSink() = default;
  ByteSink(const ByteSink&) = delete;
  ByteSink& operator=(const ByteSink&) = delete;
  virtual ~ByteSink() = default;

  /// When it returns, the bytes outlive this process, though not a loss of power (but see pack_gzip).
  /// @throws WriteFault where the operating system fails to write.
  virtual void append(std::string_view bytes) = 0;

  /// Ends the file and gives it its name. @throws WriteFault.
  virtual void finish() = 0;
};

/// A file that grows as `PATH.part` and is renamed to PATH when it is finished: PATH is never half a
/// recording, an older one stays until the new one is whole, and what a killed program leaves says so by its
/// name. What is there and no regular file (a pipe, a terminal) is written directly.
class FileSink final : public ByteSink {
 public:
  /// @throws WriteFault where the file cannot be made.
  explicit FileSink(const std::filesystem::path& path);
  ~FileSink() override;

  void append(std::string_view bytes) override;
  void finish() override;

  /// Writes over bytes that were appended before.
  void overwrite(std::uint64_t offset, std::string_view bytes);

  /// Whether overwrite() can work: not for a pipe.
  bool is_regular() const { return !part_.empty(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  [[noreturn]] void fail(int error) const;

  std::filesystem::path path_;
  std::filesystem::path part_;  // empty: written directly
  int descriptor_ = -1;
};

/// Packs what passes through as gzip; what was appended can be unpacked even if the end never comes.
/// Up to seven pieces are held back before that is so, or compression would suffer.
std::unique_ptr<ByteSink> pack_gzip(std::unique_ptr<ByteSink> packed);

}  // namespace scanbed::hw
