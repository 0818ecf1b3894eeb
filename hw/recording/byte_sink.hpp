// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include "hw/recording/new_file.hpp"

namespace scanbed::hw {

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

/// A file that grows as `PATH.part` and gets its name when it is finished; see NewFile. What a killed program
/// leaves says so by its name.
class FileSink final : public ByteSink {
 public:
  /// @throws WriteFault where the file cannot be made, or another sink is writing it.
  explicit FileSink(const std::filesystem::path& path) : file_(path, NewFile::Unfinished::kKept) {}

  void append(std::string_view bytes) override;
  void finish() override { file_.finish(); }

  /// Writes over bytes that were appended before.
  void overwrite(std::uint64_t offset, std::string_view bytes);

  /// Whether overwrite() can work: not for a pipe.
  bool is_regular() const { return file_.is_regular(); }
  const std::filesystem::path& path() const { return file_.path(); }

 private:
  NewFile file_;
};

/// Packs what passes through as gzip; what was appended can be unpacked even if the end never comes.
/// Up to seven pieces are held back before that is so, or compression would suffer.
std::unique_ptr<ByteSink> pack_gzip(std::unique_ptr<ByteSink> packed);

}  // namespace scanbed::hw
