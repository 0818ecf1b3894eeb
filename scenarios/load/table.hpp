// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/load/value.hpp"

namespace scanbed::scenarios {

/// A map whose keys are taken one by one; finish() then refuses what nobody took. So every reader states its
/// keys once, in the code that uses them, and the known ones of an error message are those it asked for.
class Table {
 public:
  /// @throws InputError where the value is no map.
  explicit Table(const Value& value);

  /// The value of `key`, which counts as known from now on; empty where the file leaves it out.
  std::optional<Value> take(std::string_view key);

  /// The same for a key that must be there. @throws InputError at the map's place.
  Value need(std::string_view key);

  double number(std::string_view key, double fallback, const Allowed& allowed = {});
  bool flag(std::string_view key, bool fallback);
  std::string text(std::string_view key, std::string fallback);

  /// The values of all keys, whatever they are called.
  std::vector<Value> take_all();

  /// @throws InputError at the first key that was not taken, with the nearest known key.
  void finish() const;

  const Value& value() const { return value_; }

 private:
  void note(std::string_view missing_key) const;
  std::string misspelt(std::string_view key) const;

  Value value_;
  std::vector<bool> taken_;         // one flag for each entry
  std::vector<std::string> known_;  // keys asked for
  std::set<std::string> needed_;    // those that must be there
};

}  // namespace scanbed::scenarios
