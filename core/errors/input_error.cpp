// SPDX-License-Identifier: MIT
#include "core/errors/input_error.hpp"

#include <iterator>
#include <sstream>

namespace scanbed {

void require(bool holds, std::string_view name, double value, std::string_view allowed) {
  if (holds) return;
  std::ostringstream message;
  message.precision(15);  // 5000000 as it was written, not 5e+06; 0.1 too
  message << name << ": value " << value << " is out of range; allowed: " << allowed;
  throw InputError(message.str());
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
