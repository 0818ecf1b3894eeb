// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace scanbed::scenarios {

/// A result that could not be written: a full disk, a folder that is not there.
class OutputFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Where results go: standard output, or a file that appears under its name only when it is complete.
class Output {
 public:
  /// @param path  empty or "-" is standard output. A file is written under a temporary name beside it; what
  ///              is no regular file (a device, a pipe) is written directly.
  /// @throws OutputFault where it cannot be made.
  explicit Output(const std::optional<std::filesystem::path>& path);

  /// Drops what was not committed, and the temporary file.
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// @returns false once the reader of a pipe has gone, and from then on: nobody wants the rest.
  /// @throws OutputFault where writing fails otherwise.
  bool write(std::string_view text);

  /// Writes what is left and gives the file its name. Same results as write().
  bool commit();

 private:
  bool flush();
  void open_file();
  [[noreturn]] void fail(int error) const;

  std::filesystem::path path_;       // empty: standard output
  std::filesystem::path temporary_;  // empty: none
  int descriptor_;
  bool is_buffered_ = false;  // a file; pipes and terminals get each write at once
  bool reader_gone_ = false;
  std::string buffer_;
};

/// Writes a whole text to a file or standard output.
bool write_whole(const std::optional<std::filesystem::path>& path, std::string_view text);

}  // namespace scanbed::scenarios
