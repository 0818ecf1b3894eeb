// SPDX-License-Identifier: MIT
#include "hw/sick/telegram.hpp"

#include "core/errors/ensure.hpp"
#include "hw/sick/crc.hpp"

namespace scanbed::hw {

void append_word(Bytes& bytes, unsigned word) {
  bytes.push_back(static_cast<std::uint8_t>(word & 0xFF));
  bytes.push_back(static_cast<std::uint8_t>((word >> 8) & 0xFF));
}

Bytes frame_telegram(std::uint8_t address, ByteView body) {
  SCANBED_ENSURE(!body.empty() && body.size() <= kMaxBodyBytes);
  Bytes telegram{kStx, address};
  telegram.reserve(body.size() + kFrameBytes);
  append_word(telegram, static_cast<unsigned>(body.size()));
  telegram.insert(telegram.end(), body.begin(), body.end());
  append_word(telegram, lms_crc(telegram));
  return telegram;
}

}  // namespace scanbed::hw
