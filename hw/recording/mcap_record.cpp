// SPDX-License-Identifier: MIT
#include "hw/recording/mcap_record.hpp"

#include <zlib.h>

#include "core/text/utf8.hpp"

namespace scanbed::hw {

void append_mcap_record(std::string& out, McapOp op, std::string_view content) {
  append_number(out, static_cast<std::uint8_t>(op));
  append_number(out, static_cast<std::uint64_t>(content.size()));
  out.append(content);
}

void append_mcap_text(std::string& out, std::string_view text) {
  append_number(out, static_cast<std::uint32_t>(text.size()));
  out.append(text);
}

void append_mcap_map(std::string& out, const std::map<std::string, std::string>& map) {
  std::string entries;
  for (const auto& [key, value] : map) {
    append_mcap_text(entries, as_utf8(key));
    append_mcap_text(entries, as_utf8(value));
  }
  append_mcap_text(out, entries);
}

std::map<std::string, std::string> read_mcap_map(ByteCursor& cursor) {
  std::map<std::string, std::string> map;
  ByteCursor entries(cursor.piece());
  while (entries.num_left() > 0) {
    const std::string key(entries.piece());
    map[key] = entries.piece();
  }
  // Beyond the end of everything: the outer cursor fails with the inner one.
  if (!entries.ok()) cursor.take(~std::uint64_t{0});
  return map;
}

std::uint32_t mcap_crc(std::uint32_t crc, std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace scanbed::hw
