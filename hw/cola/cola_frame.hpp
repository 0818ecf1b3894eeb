// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hw/serial/bytes.hpp"

namespace scanbed::hw {

/// Puts STX and ETX around a body.
Bytes frame_cola(std::string_view body);

/// Cuts a stream of bytes into the bodies between STX and ETX. A new STX begins anew, so that garbage and
/// half frames cost nothing else; a body longer than any sensor's is dropped.
class ColaReader {
 public:
  void feed(ByteView bytes);
  /// The next whole body; false where none is complete.
  bool next(std::string& body);

  /// Whether four STX came in a row, with which frames of CoLa B begin.
  bool is_binary() const { return is_binary_; }

 private:
  std::string buffer_;
  std::size_t num_starts_ = 0;  // STX in a row at the end of what was fed
  bool is_binary_ = false;
};

/// Fields of a body, cut at single blanks.
class ColaTokens {
 public:
  explicit ColaTokens(std::string_view body) : rest_(body) {}

  /// The next field; "" at the end.
  std::string_view next();
  /// The next field as hexadecimal number of at most 32 bits; empty where it is none.
  std::optional<std::uint32_t> next_hex();
  std::optional<std::int32_t> next_signed();  ///< in two's complement of 32 bits
  std::optional<float> next_float();          ///< of exactly 8 digits

 private:
  std::string_view rest_;
};

/// A number as a device writes it: hexadecimal, upper case, no leading zeros.
std::string to_cola_hex(std::uint32_t value);
std::string to_cola_hex(float value);

/// "method access denied" and such, for the number behind sFA.
std::string cola_error_text(std::uint32_t code);

}  // namespace scanbed::hw
