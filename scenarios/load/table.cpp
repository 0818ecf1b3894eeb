// SPDX-License-Identifier: MIT
#include "scenarios/load/table.hpp"

#include <fmt/format.h>

#include "scenarios/load/nearest_name.hpp"

namespace scanbed::scenarios {

Table::Table(const Value& value) : value_(value), taken_(value.node().entries.size(), false) {
  note("");
  if (value.notes().asked != nullptr) value.notes().asked->add_form(Asked::Form::kMap);
  if (value.node().kind != TreeNode::Kind::kMap) value.refuse("expected a map of keys and values");
}

// Before a fault is told: what is noted last is then what is wrong.
void Table::note(std::string_view missing_key) const {
  const Notes& notes = value_.notes();
  if (notes.asked == nullptr) return;
  notes.recorder->last = {&value_.node(), notes.asked, Asked::Form::kMap, std::string(missing_key)};
}

std::optional<Value> Table::take(std::string_view key) {
  known_.emplace_back(key);
  const Notes notes = value_.notes().of_key(key);
  const std::vector<NodeEntry>& entries = value_.node().entries;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (entries[i].key != key) continue;
    taken_[i] = true;
    return Value(entries[i].value, entries[i].key, value_.variables(), notes);
  }
  return std::nullopt;
}

std::vector<Value> Table::take_all() {
  std::vector<Value> values;
  const Notes notes = value_.notes().of_any_key();
  for (const NodeEntry& entry : value_.node().entries) {
    values.emplace_back(entry.value, entry.key, value_.variables(), notes);
  }
  taken_.assign(taken_.size(), true);
  return values;
}

Value Table::need(std::string_view key) {
  needed_.emplace(key);
  if (const std::optional<Value> found = take(key)) return *found;
  note(key);
  value_.refuse(fmt::format("missing key '{}'{}", key, misspelt(key)));
}

// Of the keys that nothing has asked for yet, one that may have been meant.
std::string Table::misspelt(std::string_view key) const {
  constexpr std::size_t kMinLetters = 3;  // shorter ones are near everything
  if (key.size() < kMinLetters) return {};
  const std::vector<std::string> missing{std::string(key)};
  const std::vector<NodeEntry>& entries = value_.node().entries;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (taken_[i] || !nearest_name(entries[i].key, missing)) continue;
    return fmt::format("; did you mean it by {} on line {}?", quote(entries[i].key), entries[i].place.line);
  }
  return {};
}

double Table::number(std::string_view key, double fallback, const Allowed& allowed) {
  const std::optional<Value> found = take(key);
  return found ? found->number(allowed) : fallback;
}

bool Table::flag(std::string_view key, bool fallback) {
  const std::optional<Value> found = take(key);
  return found ? found->flag() : fallback;
}

std::string Table::text(std::string_view key, std::string fallback) {
  const std::optional<Value> found = take(key);
  return found ? found->text() : std::move(fallback);
}

void Table::finish() const {
  const std::vector<NodeEntry>& entries = value_.node().entries;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (taken_[i]) continue;
    const std::string& key = entries[i].key;
    refuse(entries[i].place, fmt::format("unknown key {}{}", quote(key), name_hint(key, known_, "keys")));
  }
  if (value_.notes().asked != nullptr) value_.notes().asked->add_whole_map(needed_);
}

}  // namespace scanbed::scenarios
