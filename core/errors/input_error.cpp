// SPDX-License-Identifier: MIT
#include "core/errors/input_error.hpp"

#include <sstream>

namespace scanbed {

void require(bool holds, std::string_view name, double value, std::string_view allowed) {
  if (holds) return;
  std::ostringstream message;
  message << name << ": value " << value << " is out of range; allowed: " << allowed;
  throw InputError(message.str());
}

}  // namespace scanbed
