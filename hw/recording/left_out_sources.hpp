// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace scanbed::hw {

/// Names of the sources in a recording that were not asked for: for the message where there is none of those
/// that were.
class LeftOutSources {
 public:
  /// Keeps the first ones; so many names are for no message.
  void add(std::string_view source);

  /// What follows "holds no scan": " with only=RLASER; it has scans of FLASER, RAWLASER1". Empty where `only`
  /// is: nothing was left out.
  std::string text(const std::string& only) const;

 private:
  std::set<std::string> names_;
};

}  // namespace scanbed::hw
