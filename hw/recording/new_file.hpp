// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stdexcept>

#include "hw/serial/file_descriptor.hpp"

namespace scanbed::hw {

/// What could not be written: a full disk, a folder that is not there. The message names the file.
class WriteFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The file that a link leads to, even one that is not there yet; which canonical() would not follow.
std::filesystem::path behind_links(std::filesystem::path path);

/// A file that grows under another name beside its own, and gets its own when it is finished: under that name
/// it is never half, and an older one stays until the new one is whole. A link is written through: the file
/// that it leads to is the one that is replaced. What is there and no regular file (a pipe, a terminal) is
/// written directly.
class NewFile {
 public:
  /// What becomes of a file that is not finished.
  enum class Unfinished {
    kRemoved,  ///< it grows as `.NAME.PROCESS.part` and goes away again
    kKept,     ///< it grows as `NAME.part` and stays; a second writer of that is refused while there is one
  };

  /// @throws WriteFault where the file cannot be made, or is one that another writer keeps.
  NewFile(const std::filesystem::path& path, Unfinished unfinished);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  int descriptor() const { return descriptor_.get(); }
  const std::filesystem::path& path() const { return path_; }

  /// Where it grows, for programs that write to a name.
  const std::filesystem::path& growing() const { return part_.empty() ? path_ : part_; }

  /// Whether it grows under another name: not so what is written directly.
  bool is_regular() const { return !part_.empty(); }

  /// Gives the file its name. Nothing may be written after it. @throws WriteFault.
  void finish();

  /// @throws WriteFault for an error of the operating system.
  [[noreturn]] void fail(int error) const;

 private:
  FileDescriptor open() const;
  FileDescriptor open_alone() const;

  std::filesystem::path path_;
  std::filesystem::path part_;  // empty: written directly, or finished
  Unfinished unfinished_;
  FileDescriptor descriptor_;
};

}  // namespace scanbed::hw
