// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hw/serial/bytes.hpp"

namespace scanbed::hw {

inline constexpr std::uint8_t kStx = 0x02;
inline constexpr std::uint8_t kAcknowledge = 0x06;
inline constexpr std::uint8_t kNotAcknowledge = 0x15;

/// Set in the address of all that a sensor sends, beside its own address; clear in what a host sends.
inline constexpr std::uint8_t kReplyAddress = 0x80;

/// STX, address, length and check word: what a telegram has beside its body.
inline constexpr std::size_t kFrameBytes = 6;

/// The longest body: 401 values with both indices. A longer length field is garbage.
inline constexpr std::size_t kMaxBodyBytes = 808;

/// Puts STX, address, length and check word around a body: command, data and, from a sensor, status.
///
/// @pre  1 <= body.size() <= kMaxBodyBytes. Checked; aborts.
/// @par Source  SICK, "Telegrams for Configuring and Operating the LMS 2xx", telegram structure.
Bytes frame_telegram(std::uint8_t address, ByteView body);

/// Little-endian word at `offset`. @pre  both bytes exist.
inline unsigned read_word(ByteView bytes, std::size_t offset) {
  return bytes[offset] | (static_cast<unsigned>(bytes[offset + 1]) << 8);
}

/// Appends a little-endian word.
void append_word(Bytes& bytes, unsigned word);

}  // namespace scanbed::hw
