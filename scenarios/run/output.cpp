// SPDX-License-Identifier: MIT
#include "scenarios/run/output.hpp"

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

}  // namespace

Output::Output(const std::optional<fs::path>& path, Unfinished unfinished) : descriptor_(STDOUT_FILENO) {
  if (path && *path != "-") {
    file_.emplace(*path, unfinished);
    descriptor_ = file_->descriptor();
  }
  is_buffered_ = is_regular(descriptor_);
}

void Output::fail(int error) {
  has_failed_ = true;
  buffer_.clear();
  if (file_) file_->fail(error);
  throw OutputFault(fmt::format("standard output: cannot be written: {}", std::strerror(error)));
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
  if (file_ && !has_failed_) file_->finish();
  return !reader_gone_;
}

bool write_whole(const std::optional<fs::path>& path, std::string_view text) {
  Output output(path);
  output.write(text);
  return output.commit();
}

}  // namespace scanbed::scenarios
