// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/scan/lms_word.hpp"
#include "hw/serial/bytes.hpp"
#include "hw/sick/lms_reply.hpp"
#include "hw/sick/lms_variant.hpp"

namespace scanbed::hw {

/// Measured values as they travel in B0h: a whole scan, or one turn of the mirror out of several interlaced.
struct ScanTelegram {
  RangeUnit unit = RangeUnit::kMillimetre;
  bool is_partial = false;
  int partial = 0;                   ///< which turn, in quarters of a degree: 0 to 3
  std::vector<std::uint16_t> words;  ///< counter-clockwise, the first is the rightmost beam
  /// Of the scan and of the telegram, modulo 256; sent where the configuration asks for them.
  struct Indices {
    std::uint8_t scan = 0;
    std::uint8_t telegram = 0;
  };
  std::optional<Indices> indices;
  LmsStatusByte status;
};

/// Body of the telegram.
/// @pre  at most 401 words, partial in [0, 3]. Checked; aborts.
Bytes encode(const ScanTelegram& telegram);

/// Parses a body into `telegram`, reusing its storage; false where it is no B0h, or its length is not that of
/// its number of values, with or without indices.
bool parse_scan(ByteView body, ScanTelegram& telegram);

/// What a stream must look like beside its check word, which misses certain pairs of flipped bits.
struct ScanExpectation {
  LmsVariant variant;
  RangeUnit unit = RangeUnit::kMillimetre;
  bool has_indices = false;
  bool is_partial = false;  ///< turns of 181, 180, 180 and 180 values, always 180 degrees wide
};

bool matches(const ScanTelegram& telegram, const ScanExpectation& expected);

/// Values of one turn out of four: 181 in the first, 180 in the others.
inline int partial_size(int partial) {
  return partial == 0 ? 181 : 180;
}

}  // namespace scanbed::hw
