// SPDX-License-Identifier: MIT
#pragma once

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

}  // namespace scanbed
