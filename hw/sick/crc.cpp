// SPDX-License-Identifier: MIT
#include "hw/sick/crc.hpp"

#include <array>
#include <cstddef>

namespace scanbed::hw {
namespace {

constexpr unsigned kPolynomial = 0x8005;

constexpr unsigned step(unsigned crc) {
  return ((crc << 1) & 0xFFFFU) ^ ((crc & 0x8000U) != 0 ? kPolynomial : 0U);
}

// Remainder of the eight bits that stand above the register.
constexpr std::array<std::uint16_t, 256> make_table() {
  std::array<std::uint16_t, 256> table{};
  for (unsigned high = 0; high < 256; ++high) {
    unsigned crc = high << 8;
    for (int bit = 0; bit < 8; ++bit) crc = step(crc);
    table[high] = static_cast<std::uint16_t>(crc);
  }
  return table;
}

constexpr std::array<std::uint16_t, 256> kTable = make_table();
constexpr std::size_t kBlock = 8;

// Eight steps at once: shifting and reducing are linear, so the eight words are lined up and summed first,
// free of each other, and the eight bits that stick out are reduced by one look-up.
unsigned step_block(unsigned crc, const std::uint8_t* byte, unsigned previous) {
  unsigned sum = crc << kBlock;
  for (std::size_t i = 0; i < kBlock; ++i) {
    sum ^= (byte[i] | (previous << 8)) << (kBlock - 1 - i);
    previous = byte[i];
  }
  return (sum & 0xFFFFU) ^ kTable[sum >> 16];
}

}  // namespace

std::uint16_t lms_crc(ByteView bytes) {
  unsigned crc = 0;
  unsigned previous = 0;
  std::size_t i = 0;
  for (; i + kBlock <= bytes.size(); i += kBlock) {
    crc = step_block(crc, bytes.data() + i, previous);
    previous = bytes[i + kBlock - 1];
  }
  for (; i < bytes.size(); ++i) {
    crc = step(crc) ^ bytes[i] ^ (previous << 8);
    previous = bytes[i];
  }
  return static_cast<std::uint16_t>(crc);
}

}  // namespace scanbed::hw
