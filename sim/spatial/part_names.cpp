// SPDX-License-Identifier: MIT
#include "sim/spatial/part_names.hpp"

namespace scanbed::sim {
namespace {

// XML 1.0 cannot carry control characters, not even escaped: they are spelled out ("\x01").
std::string printable(std::string_view id) {
  constexpr const char* kHex = "0123456789abcdef";
  std::string text;
  for (const char c : id) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7f) {
      text += c;
    } else {
      text += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
    }
  }
  return text;
}

std::string join(std::string_view kind, std::string_view id, std::string_view part) {
  return std::string(kind) + "/" + printable(id) + "/" + std::string(part);
}

}  // namespace

std::string solid_name(std::string_view id, int n) {
  return join("solid", id, std::to_string(n));
}

std::string sheet_name(std::string_view id, int n) {
  return join("solid", id, std::to_string(n) + ".sheet");
}

std::string walker_name(std::string_view id, std::string_view part) {
  return join("walker", id, part);
}

std::string tow_name(std::string_view id, std::string_view part) {
  return join("tow", id, part);
}

}  // namespace scanbed::sim
