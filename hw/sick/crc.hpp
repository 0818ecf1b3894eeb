// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hw/serial/bytes.hpp"

namespace scanbed::hw {

/// The check word of an LMS 2xx telegram, over STX to the last byte before the check word. Not a CRC-16 of
/// common use: each byte enters twice, as low byte and one step later as high byte, and the register moves
/// one bit a byte.
///
/// It is weak: bit k of one byte and bit k + 1 of the next, both flipped, leave it as it was. What reads a
/// telegram therefore checks lengths and contents as well (scan_telegram.hpp).
///
/// @par Source  SICK, "Telegrams for Configuring and Operating the LMS 2xx", CRC generator polynomial 8005h.
std::uint16_t lms_crc(ByteView bytes);

}  // namespace scanbed::hw
