// SPDX-License-Identifier: MIT
#include "scenarios/command/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace scanbed::scenarios {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBuffer = 1 << 16;

bool is_regular(int descriptor) {
  struct stat status {};
  return fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

// A link is written through, not replaced: the file that it leads to.
fs::path resolve(const fs::path& path) {
  std::error_code error;
  const fs::path resolved = fs::weakly_canonical(path, error);
  return error ? path : resolved;
}

}  // namespace

Output::Output(const std::optional<fs::path>& path) : descriptor_(STDOUT_FILENO) {
  if (path && *path != "-") {
    path_ = *path;
    open_file();
  }
  is_buffered_ = is_regular(descriptor_);
}

Output::~Output() {
  if (path_.empty()) return;
  ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void Output::open_file() {
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  if (fs::is_directory(status)) throw OutputFault(path_.string() + ": is a folder, not a file");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    path_ = resolve(path_);
    temporary_ = path_.parent_path() / fmt::format(".{}.{}.part", path_.filename().string(), ::getpid());
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  }
  if (descriptor_ < 0) fail(errno);
}

void Output::fail(int error) const {
  const std::string name = path_.empty() ? "standard output" : path_.string();
  throw OutputFault(fmt::format("{}: cannot be written: {}", name, std::strerror(error)));
}

bool Output::write(std::string_view text) {
  if (reader_gone_) return false;
  buffer_ += text;
  return !is_buffered_ || buffer_.size() >= kBuffer ? flush() : true;
}

bool Output::flush() {
  std::string_view left = buffer_;
  while (!left.empty() && !reader_gone_) {
    const ssize_t count = ::write(descriptor_, left.data(), left.size());
    if (count >= 0) {
      left.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno == EPIPE) {
      reader_gone_ = true;
    } else if (errno != EINTR) {
      fail(errno);
    }
  }
  buffer_.clear();
  return !reader_gone_;
}

bool Output::commit() {
  flush();
  if (!temporary_.empty()) {
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail(errno);
    temporary_.clear();
  }
  return !reader_gone_;
}

bool write_whole(const std::optional<fs::path>& path, std::string_view text) {
  Output output(path);
  output.write(text);
  return output.commit();
}

}  // namespace scanbed::scenarios
