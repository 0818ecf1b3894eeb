// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "hw/recording/new_file.hpp"

namespace scanbed::scenarios {

/// A result that could not be written: a full disk, a folder that is not there.
using OutputFault = hw::WriteFault;

/// Where results go: standard output, or a file that appears under its name only when it is complete (see
/// hw::NewFile).
class Output {
 public:
  using Unfinished = hw::NewFile::Unfinished;

  /// @param path  empty or "-" is standard output.
  /// @throws OutputFault where it cannot be made.
  explicit Output(const std::optional<std::filesystem::path>& path,
                  Unfinished unfinished = Unfinished::kRemoved);

  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// @returns false once the reader of a pipe has gone, and from then on: nobody wants the rest.
  /// @throws OutputFault where writing fails otherwise.
  bool write(std::string_view text);

  /// Writes what is left and gives the file its name; not one of which a part could not be written. Same
  /// results as write().
  bool commit();

 private:
  bool flush();
  [[noreturn]] void fail(int error);

  std::optional<hw::NewFile> file_;  // empty: standard output
  int descriptor_;
  bool is_buffered_ = false;  // a file; pipes and terminals get each write at once
  bool reader_gone_ = false;
  bool has_failed_ = false;
  std::string buffer_;
};

/// Writes a whole text to a file or standard output.
bool write_whole(const std::optional<std::filesystem::path>& path, std::string_view text);

}  // namespace scanbed::scenarios
