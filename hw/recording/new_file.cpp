// SPDX-License-Identifier: MIT
#include "hw/recording/new_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace scanbed::hw {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kAsUmaskAllows = 0666;

fs::path part_of(const fs::path& path, NewFile::Unfinished unfinished) {
  std::string name = path.filename().string();
  if (unfinished == NewFile::Unfinished::kRemoved) name = "." + name + "." + std::to_string(::getpid());
  return path.parent_path() / (name + ".part");
}

/// Whether the name still leads to the open file.
bool is_named(const FileDescriptor& file, const fs::path& name) {
  struct stat opened = {};
  struct stat named = {};
  return ::fstat(file.get(), &opened) == 0 && ::stat(name.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

fs::path behind_links(fs::path path) {
  constexpr int kMostLinks = 40;  // as many as Linux follows
  std::error_code error;
  for (int i = 0; i < kMostLinks && fs::is_symlink(path, error); ++i) {
    path = path.parent_path() / fs::read_symlink(path, error);
  }
  return path;
}

NewFile::NewFile(const fs::path& path, Unfinished unfinished) : path_(path), unfinished_(unfinished) {
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  if (fs::is_directory(status)) throw WriteFault(path_.string() + ": is a folder, not a file");
  if (!fs::exists(status) || fs::is_regular_file(status)) {
    path_ = behind_links(path_);
    part_ = part_of(path_, unfinished_);
  }
  descriptor_ = is_regular() && unfinished_ == Unfinished::kKept ? open_alone() : open();
}

NewFile::~NewFile() {
  if (is_regular() && descriptor_.is_open() && unfinished_ == Unfinished::kRemoved) ::unlink(part_.c_str());
}

void NewFile::fail(int error) const {
  throw WriteFault(path_.string() + ": cannot be written: " + std::generic_category().message(error));
}

FileDescriptor NewFile::open() const {
  const int truncation = is_regular() ? O_TRUNC | O_CREAT : 0;
  FileDescriptor file(::open(growing().c_str(), O_WRONLY | O_CLOEXEC | truncation, kAsUmaskAllows));
  if (!file.is_open()) fail(errno);
  return file;
}

/// Opens the file and locks it until it is closed. A file system that has no locks leaves it to the user.
FileDescriptor NewFile::open_alone() const {
  for (;;) {
    FileDescriptor file(::open(part_.c_str(), O_WRONLY | O_CLOEXEC | O_CREAT, kAsUmaskAllows));
    if (!file.is_open()) fail(errno);
    if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      throw WriteFault(path_.string() + ": is being written already, as " + part_.string());
    }
    // Between opening and locking, another writer may have finished this file and given it its name.
    if (!is_named(file, part_)) continue;
    if (::ftruncate(file.get(), 0) != 0) fail(errno);
    return file;
  }
}

void NewFile::finish() {
  // Some file systems tell of a full disk only when a descriptor is closed. The lock stays with the other one
  // until the file has its name.
  const int twin = ::dup(descriptor());
  if (twin < 0 || ::close(twin) != 0) fail(errno);
  if (is_regular() && ::rename(part_.c_str(), path_.c_str()) != 0) fail(errno);
  descriptor_.reset();
}

}  // namespace scanbed::hw
