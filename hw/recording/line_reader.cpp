// SPDX-License-Identifier: MIT
#include "hw/recording/line_reader.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace scanbed::hw {
namespace {

constexpr std::size_t kReadBlock = std::size_t{1} << 16;

}  // namespace

LineReader::LineReader(std::unique_ptr<ByteStream> bytes) : bytes_(std::move(bytes)), buffer_(kReadBlock) {}

bool LineReader::next(TextLine& line) {
  bool is_too_long = false;
  for (;;) {
    const std::size_t end = unread().find('\n', searched_);
    if (end != std::string_view::npos) {
      take(end, 1, line);
      break;
    }
    searched_ = last_ - first_;
    // Two spare bytes: the CR of a line that is just not too long, and one that shows it is.
    if (searched_ > kMaxLine + 1) {
      is_too_long = true;
      // The beginning stays in the buffer; what follows is dropped until the line's end turns up.
      last_ = first_ + kMaxLine + 1;
      searched_ = kMaxLine + 1;
    }
    if (fetch_more()) continue;
    if (!take_rest(line)) return false;
    break;
  }
  if (num_lines_ == 0 && line.text.starts_with(kByteOrderMark)) {
    line.text.remove_prefix(kByteOrderMark.size());
  }
  line.number = ++num_lines_;
  line.is_too_long = is_too_long || line.text.size() > kMaxLine;
  line.text = line.text.substr(0, kMaxLine);
  return true;
}

bool LineReader::fetch_more() {
  if (first_ > 0) {
    std::copy_n(buffer_.data() + first_, last_ - first_, buffer_.data());
    last_ -= std::exchange(first_, 0);
  }
  if (buffer_.size() - last_ < kReadBlock) buffer_.resize(last_ + kReadBlock);
  const std::size_t num_read = bytes_->read(std::span(buffer_).subspan(last_));
  last_ += num_read;
  return num_read > 0;
}

bool LineReader::take(std::size_t length, std::size_t num_end_bytes, TextLine& line) {
  line.text = unread().substr(0, length);
  if (line.text.ends_with('\r')) line.text.remove_suffix(1);
  first_ += length + num_end_bytes;
  searched_ = 0;
  return true;
}

bool LineReader::take_rest(TextLine& line) {
  if (first_ == last_ || bytes_->end() != StreamEnd::kClean) return false;
  return take(last_ - first_, 0, line);
}

}  // namespace scanbed::hw
