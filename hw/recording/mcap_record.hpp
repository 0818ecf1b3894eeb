// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "hw/recording/little_endian.hpp"

namespace scanbed::hw {

/// MCAP files begin and end with this.
inline constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n";

enum class McapOp : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0b,
  kMetadata = 0x0c,
  kMetadataIndex = 0x0d,
  kSummaryOffset = 0x0e,
  kDataEnd = 0x0f,
};

/// Opcode and length in front of each record's content.
inline constexpr std::uint64_t kMcapPrefix = 9;

void append_mcap_record(std::string& out, McapOp op, std::string_view content);

/// A text or another piece, its length (32 bits) in front.
void append_mcap_text(std::string& out, std::string_view text);

/// A map of texts (see as_utf8), its length in bytes in front.
void append_mcap_map(std::string& out, const std::map<std::string, std::string>& map);

/// Reads such a map. What is left over or too short makes the cursor fail.
std::map<std::string, std::string> read_mcap_map(ByteCursor& cursor);

/// CRC-32 of zlib and PNG, continued: that of nothing is 0.
std::uint32_t mcap_crc(std::uint32_t crc, std::string_view bytes);

}  // namespace scanbed::hw
