// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace scanbed {

/// A bad value from outside: a file, a flag, a parameter. The message is one line for the user: what, where,
/// expected.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws InputError "name: value 3.2 is out of range; allowed: (0, 0.401]" unless `holds`.
void require(bool holds, std::string_view name, double value, std::string_view allowed);

/// Throws InputError "name: value 7 is out of range; allowed: off, on" unless a word has this number.
void require_word(std::int64_t number, std::string_view name, std::span<const std::string_view> words);

/// The same of an enum whose values, counted from 0, have these words.
template <typename Choice>
void require_choice(Choice value, std::string_view name, std::span<const std::string_view> words) {
  require_word(static_cast<std::int64_t>(value), name, words);
}

}  // namespace scanbed
