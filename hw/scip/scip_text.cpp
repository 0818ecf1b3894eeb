// SPDX-License-Identifier: MIT
#include "hw/scip/scip_text.hpp"

#include <algorithm>
#include <utility>

namespace scanbed::hw {
namespace {

constexpr char kFirst = '0';
constexpr char kLast = 'o';
constexpr std::size_t kBlock = 64;
constexpr std::size_t kLongestMessage = std::size_t{1} << 16;

}  // namespace

char scip_sum(std::string_view body) {
  unsigned sum = 0;
  for (const char c : body) sum += static_cast<unsigned char>(c);
  return static_cast<char>((sum & 0x3FU) + kFirst);
}

std::optional<std::string_view> strip_sum(std::string_view line) {
  if (line.empty()) return std::nullopt;
  const std::string_view body = line.substr(0, line.size() - 1);
  if (scip_sum(body) != line.back()) return std::nullopt;
  return body;
}

std::optional<std::int64_t> decode_scip(std::string_view text) {
  std::int64_t value = 0;
  for (const char c : text) {
    if (c < kFirst || c > kLast) return std::nullopt;
    value = value << 6 | (c - kFirst);
  }
  return value;
}

std::string encode_scip(std::int64_t value, int num_chars) {
  std::string text;
  for (int shift = 6 * (num_chars - 1); shift >= 0; shift -= 6) {
    text.push_back(static_cast<char>(((value >> shift) & 0x3F) + kFirst));
  }
  return text;
}

std::string to_scip_blocks(std::string_view data) {
  std::string text;
  for (std::size_t at = 0; at < data.size(); at += kBlock) {
    const std::string_view block = data.substr(at, kBlock);
    text += block;
    text += scip_sum(block);
    text += '\n';
  }
  return text;
}

std::optional<std::string> join_scip_blocks(const std::vector<std::string>& lines) {
  std::string data;
  for (const std::string& line : lines) {
    const auto body = strip_sum(line);
    if (!body) return std::nullopt;
    data += *body;
  }
  return data;
}

void ScipReader::feed(std::string_view bytes) {
  buffer_ += bytes;
}

bool ScipReader::next(std::vector<std::string>& lines) {
  std::size_t at = 0;
  bool is_whole = false;
  while (!is_whole) {
    const std::size_t end = buffer_.find('\n', at);
    if (end == std::string::npos) break;
    std::string line = buffer_.substr(at, end - at);
    at = end + 1;
    is_whole = line.empty() && !lines_.empty();
    size_ += line.size();
    if (!line.empty()) lines_.push_back(std::move(line));
    if (size_ > kLongestMessage) {
      lines_.clear();
      size_ = 0;
    }
  }
  buffer_.erase(0, at);
  if (buffer_.size() > kLongestMessage) buffer_.clear();
  if (!is_whole) return false;
  lines = std::exchange(lines_, {});
  size_ = 0;
  return true;
}

void ScipReader::clear() {
  buffer_.clear();
  lines_.clear();
  size_ = 0;
}

}  // namespace scanbed::hw
