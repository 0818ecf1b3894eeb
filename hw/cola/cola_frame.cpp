// SPDX-License-Identifier: MIT
#include "hw/cola/cola_frame.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cstdio>

namespace scanbed::hw {
namespace {

constexpr char kStart = '\x02';
constexpr char kEnd = '\x03';
constexpr std::size_t kBinaryStarts = 4;
constexpr std::size_t kLongestBody = std::size_t{128} * 1024;

constexpr std::array<const char*, 18> kErrors = {"no error",
                                                 "method access denied",
                                                 "unknown method",
                                                 "unknown variable",
                                                 "value out of range",
                                                 "invalid data",
                                                 "unknown error",
                                                 "buffer overflow",
                                                 "parameters missing",
                                                 "unknown type",
                                                 "write access denied (not logged in)",
                                                 "unknown nameserver command",
                                                 "unknown CoLa command",
                                                 "server busy",
                                                 "array out of bounds",
                                                 "unknown event",
                                                 "value overflow",
                                                 "invalid character"};

}  // namespace

Bytes frame_cola(std::string_view body) {
  Bytes bytes{static_cast<std::uint8_t>(kStart)};
  bytes.insert(bytes.end(), body.begin(), body.end());
  bytes.push_back(static_cast<std::uint8_t>(kEnd));
  return bytes;
}

void ColaReader::feed(ByteView bytes) {
  buffer_.append(bytes.begin(), bytes.end());
  for (const std::uint8_t byte : bytes) {
    num_starts_ = byte == kStart ? num_starts_ + 1 : 0;
    is_binary_ = is_binary_ || num_starts_ == kBinaryStarts;
  }
}

bool ColaReader::next(std::string& body) {
  for (std::size_t end = buffer_.find(kEnd); end != std::string::npos; end = buffer_.find(kEnd)) {
    const std::size_t start = buffer_.rfind(kStart, end);
    const bool is_frame = start != std::string::npos && end - start <= kLongestBody;
    if (is_frame) body.assign(buffer_, start + 1, end - start - 1);
    buffer_.erase(0, end + 1);
    if (is_frame) return true;
  }
  // Half a frame that long is none.
  if (buffer_.size() > kLongestBody) buffer_.clear();
  return false;
}

std::string_view ColaTokens::next() {
  if (rest_.empty()) return "";
  const std::size_t blank = rest_.find(' ');
  const std::string_view token = rest_.substr(0, blank);
  rest_.remove_prefix(blank == std::string_view::npos ? rest_.size() : blank + 1);
  return token;
}

std::optional<std::uint32_t> ColaTokens::next_hex() {
  const std::string_view token = next();
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value, 16);
  if (token.empty() || error != std::errc() || end != token.data() + token.size()) return std::nullopt;
  return value;
}

std::optional<std::int32_t> ColaTokens::next_signed() {
  const auto value = next_hex();
  if (!value) return std::nullopt;
  return std::bit_cast<std::int32_t>(*value);
}

std::optional<float> ColaTokens::next_float() {
  const auto value = next_hex();
  if (!value) return std::nullopt;
  return std::bit_cast<float>(*value);
}

std::string to_cola_hex(std::uint32_t value) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%X", value);
  return text.data();
}

std::string to_cola_hex(float value) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%08X", std::bit_cast<std::uint32_t>(value));
  return text.data();
}

std::string cola_error_text(std::uint32_t code) {
  return code < kErrors.size() ? kErrors.at(code) : "error " + to_cola_hex(code);
}

}  // namespace scanbed::hw
