// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace scanbed::hw {

/// How a recording is read.
struct RecordingOptions {
  std::string only;  ///< read this message (CARMEN), topic (bag, MCAP) or device (Player) alone; empty: all
  std::optional<double> no_return_m;  ///< readings from here on mean "no return"
  /// Asked ten times a second where bytes are waited for; true ends the wait. May be empty.
  std::function<bool()> is_interrupted;

  void validate() const;  ///< @throws InputError naming the first field that is not allowed
};

}  // namespace scanbed::hw
