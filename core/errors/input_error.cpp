// SPDX-License-Identifier: MIT
#include "core/errors/input_error.hpp"

#include <iterator>

#include "core/text/number_text.hpp"

namespace scanbed {

void require(bool holds, std::string_view name, double value, std::string_view allowed) {
  if (holds) return;
  throw InputError(std::string(name) + ": value " + number_text(value) +
                   " is out of range; allowed: " + std::string(allowed));
}

void require_word(std::int64_t number, std::string_view name, std::span<const std::string_view> words) {
  if (number >= 0 && number < std::ssize(words)) return;
  std::string allowed;
  for (const std::string_view word : words) {
    if (!allowed.empty()) allowed += ", ";
    allowed += word;
  }
  require(false, name, static_cast<double>(number), allowed);
}

}  // namespace scanbed
