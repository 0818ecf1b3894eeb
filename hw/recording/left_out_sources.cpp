// SPDX-License-Identifier: MIT
#include "hw/recording/left_out_sources.hpp"

#include <cstddef>

namespace scanbed::hw {

void LeftOutSources::add(std::string_view source) {
  constexpr std::size_t kMostNames = 16;
  constexpr std::size_t kLongestName = 80;
  if (names_.size() < kMostNames) names_.emplace(source.substr(0, kLongestName));
}

std::string LeftOutSources::text(const std::string& only) const {
  if (only.empty()) return "";
  std::string text = " with only=" + only;
  std::string_view between = "; it has scans of ";
  for (const std::string& name : names_) {
    text.append(between).append(name.empty() ? "a source without name" : name);
    between = ", ";
  }
  return text;
}

}  // namespace scanbed::hw
