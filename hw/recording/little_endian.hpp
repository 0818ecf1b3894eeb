// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace scanbed::hw {

/// Appends the bytes of a number, least significant first.
template <std::unsigned_integral Number>
void append_number(std::string& out, Number value) {
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    out.push_back(static_cast<char>(static_cast<unsigned char>(value >> (8 * i))));
  }
}

inline void append_float(std::string& out, float value) {
  append_number(out, std::bit_cast<std::uint32_t>(value));
}

/// Reads numbers, least significant byte first, and pieces from a range of bytes; never beyond it. The first
/// failure sticks: what is read after it is zero or empty, so a caller asks once, at the end.
class ByteCursor {
 public:
  /// The bytes must outlive what is taken from them.
  explicit ByteCursor(std::string_view bytes) : rest_(bytes) {}

  template <std::unsigned_integral Number>
  Number number() {
    const std::string_view bytes = take(sizeof(Number));
    std::uint64_t value = 0;
    for (std::size_t i = bytes.size(); i-- > 0;) value = (value << 8) | static_cast<unsigned char>(bytes[i]);
    return static_cast<Number>(value);
  }

  float float32() { return std::bit_cast<float>(number<std::uint32_t>()); }

  /// The next bytes; empty after a failure.
  std::string_view take(std::uint64_t num_bytes) {
    if (num_bytes > rest_.size()) {
      is_ok_ = false;
      rest_ = {};
    }
    if (!is_ok_) return {};
    const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(num_bytes));
    rest_.remove_prefix(taken.size());
    return taken;
  }

  /// A piece that says its length first, in 32 bits.
  std::string_view piece() { return take(number<std::uint32_t>()); }

  std::size_t num_left() const { return rest_.size(); }
  bool ok() const { return is_ok_; }

 private:
  std::string_view rest_;
  bool is_ok_ = true;
};

}  // namespace scanbed::hw
