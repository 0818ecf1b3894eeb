// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace scanbed::hw {

/// What a recording holds that was not asked for or cannot be read: for the message where there is nothing
/// else.
class LeftOutSources {
 public:
  /// Keeps the first ones; so many names are for no message.
  void add(std::string_view source);

  /// Scans in a form that is not read: "sensor_msgs/LaserScan in ros1".
  void add_unread(std::string_view form);

  /// What follows "holds no scan": " with only=RLASER; it has scans of FLASER, RAWLASER1", or "; not read:
  /// sensor_msgs/LaserScan in ros1". Empty where nothing was left out.
  std::string text(const std::string& only) const;

 private:
  std::set<std::string> names_;
  std::set<std::string> unread_;
};

}  // namespace scanbed::hw
