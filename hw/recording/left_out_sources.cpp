// SPDX-License-Identifier: MIT
#include "hw/recording/left_out_sources.hpp"

#include <cstddef>

namespace scanbed::hw {

namespace {

void add_to(std::set<std::string>& names, std::string_view name) {
  constexpr std::size_t kMostNames = 16;
  constexpr std::size_t kLongestName = 80;
  if (names.size() < kMostNames) names.emplace(name.substr(0, kLongestName));
}

void append_list(std::string& text, std::string_view before, const std::set<std::string>& names) {
  for (const std::string& name : names) {
    text.append(before).append(name.empty() ? "a source without name" : name);
    before = ", ";
  }
}

}  // namespace

void LeftOutSources::add(std::string_view source) {
  add_to(names_, source);
}

void LeftOutSources::add_unread(std::string_view form) {
  add_to(unread_, form);
}

std::string LeftOutSources::text(const std::string& only) const {
  std::string text = only.empty() ? "" : " with only=" + only;
  append_list(text, "; it has scans of ", names_);
  append_list(text, "; not read: ", unread_);
  return text;
}

}  // namespace scanbed::hw
