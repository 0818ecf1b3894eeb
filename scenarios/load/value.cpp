// SPDX-License-Identifier: MIT
#include "scenarios/load/value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/angles.hpp"
#include "scenarios/load/nearest_name.hpp"
#include "scenarios/load/number.hpp"

namespace scanbed::scenarios {
namespace {

std::string_view name_of(TreeNode::Kind kind) {
  switch (kind) {
    case TreeNode::Kind::kNothing:
      return "nothing";
    case TreeNode::Kind::kScalar:
      return "a single value";
    case TreeNode::Kind::kList:
      return "a list";
    case TreeNode::Kind::kMap:
      return "a map";
  }
  return "";
}

bool holds(const Allowed& allowed, double value) {
  return (allowed.open ? value > allowed.least : value >= allowed.least) && value <= allowed.greatest;
}

std::string to_text(const Allowed& allowed) {
  const bool has_least = std::isfinite(allowed.least);
  const bool has_greatest = std::isfinite(allowed.greatest);
  if (has_least && has_greatest) {
    return fmt::format("{}{}, {}]", allowed.open ? '(' : '[', allowed.least, allowed.greatest);
  }
  if (has_least) return fmt::format("{} {}", allowed.open ? ">" : ">=", allowed.least);
  return fmt::format("<= {}", allowed.greatest);
}

}  // namespace

void Value::refuse(std::string_view message) const {
  scenarios::refuse(node_->place, fmt::format("{}: {}", name_, message));
}

// Before it is read, so that the last question of a refused tree is the one that was not answered.
void Value::note(Asked::Form form) const {
  if (notes_.asked == nullptr) return;
  notes_.asked->add_form(form);
  notes_.recorder->last = {node_, notes_.asked, form, ""};
}

void Value::note_number(Asked::Form form, const Allowed& allowed) const {
  if (notes_.asked == nullptr) return;
  notes_.asked->add_number(form, allowed);
  notes_.recorder->last.allowed = allowed;
}

const std::string& Value::scalar(std::string_view expected) const {
  if (node_->kind != TreeNode::Kind::kScalar) {
    refuse(fmt::format("expected {}, found {}", expected, name_of(node_->kind)));
  }
  return node_->text;
}

double Value::resolve(std::string_view expected) const {
  const std::string& text = scalar(expected);
  const std::optional<double> number = node_->is_quoted ? std::nullopt : parse_number(text);
  if (number) return *number;
  // In quotes only what cannot be meant as text: a plain number in quotes stays text.
  const bool is_arithmetic = looks_like_arithmetic(text) && !(node_->is_quoted && parse_number(text));
  if (!is_arithmetic) refuse(fmt::format("expected {}, found {}", expected, quote(text)));
  const Evaluated result = evaluate(text, *variables_);
  if (result.fault.empty()) return result.value;
  refuse(result.is_unknown ? result.fault : quote(text) + ": " + result.fault);
}

double Value::number(const Allowed& allowed) const {
  note(Asked::Form::kNumber);
  note_number(Asked::Form::kNumber, allowed);
  const double value = resolve("a number");
  if (!holds(allowed, value)) {
    refuse(fmt::format("value {} is out of range; allowed: {}", value, to_text(allowed)));
  }
  return value;
}

std::int64_t Value::count(const Allowed& allowed) const {
  note(Asked::Form::kCount);
  note_number(Asked::Form::kCount, allowed);
  // Through the text where it is a plain number: a double cannot hold every 64-bit seed.
  const std::optional<std::int64_t> exact =
      node_->is_quoted ? std::nullopt : parse_count(scalar("a whole number"));
  const double value = exact ? static_cast<double>(*exact) : resolve("a whole number");
  if (!exact && (value != std::floor(value) || std::abs(value) > 9e15)) {
    refuse(fmt::format("expected a whole number, found {}", value));
  }
  if (!holds(allowed, value)) {
    refuse(fmt::format("value {} is out of range; allowed: {}", value, to_text(allowed)));
  }
  return exact ? *exact : static_cast<std::int64_t>(value);
}

bool Value::flag() const {
  note(Asked::Form::kFlag);
  const std::string& text = scalar("true or false");
  if (node_->is_quoted || (text != "true" && text != "false")) {
    refuse(fmt::format("expected true or false, found {}", quote(text)));
  }
  return text == "true";
}

std::string Value::text() const {
  note(Asked::Form::kText);
  const std::string& text = scalar("text");
  if (text.empty()) refuse("expected text, found nothing");
  return text;
}

bool Value::is(const std::string& word) const {
  note(Asked::Form::kWord);
  if (notes_.asked != nullptr) notes_.asked->add_words({word});
  return node_->kind == TreeNode::Kind::kScalar && node_->text == word;
}

std::size_t Value::choice(std::span<const std::string> words) const {
  note(Asked::Form::kWord);
  if (notes_.asked != nullptr) notes_.asked->add_words({words.begin(), words.end()});
  const std::string& text = scalar("one of " + fmt::format("{}", fmt::join(words, ", ")));
  const auto found = std::find(words.begin(), words.end(), text);
  if (found == words.end()) {
    refuse(fmt::format("unknown value {}{}", quote(text), name_hint(text, words, "values")));
  }
  return static_cast<std::size_t>(found - words.begin());
}

std::vector<Value> Value::listed(std::size_t least, std::size_t greatest) const {
  note(Asked::Form::kList);
  if (notes_.asked != nullptr) notes_.asked->add_list(least, greatest);
  if (node_->kind != TreeNode::Kind::kList) {
    refuse(fmt::format("expected a list, found {}", name_of(node_->kind)));
  }
  std::vector<Value> items;
  items.reserve(node_->items.size());
  for (const TreeNode& item : node_->items) items.emplace_back(item, name_, *variables_, notes_.of_item());
  return items;
}

std::vector<Value> Value::items() const {
  return listed(0, std::numeric_limits<std::size_t>::max());
}

std::vector<Value> Value::items(std::size_t num_items) const {
  std::vector<Value> found = listed(num_items, num_items);
  if (found.size() != num_items) {
    refuse(fmt::format("expected {} values, found {}", num_items, found.size()));
  }
  return found;
}

Eigen::Vector2d Value::point_m() const {
  const std::vector<Value> xy = items(2);
  return {xy[0].number(kCoordinate), xy[1].number(kCoordinate)};
}

std::vector<Eigen::Vector2d> Value::points_m(std::size_t least) const {
  std::vector<Eigen::Vector2d> points;
  for (const Value& item : listed(least, std::numeric_limits<std::size_t>::max())) {
    points.push_back(item.point_m());
  }
  if (points.size() < least) {
    refuse(fmt::format("expected at least {} points, found {}", least, points.size()));
  }
  return points;
}

Pose2 Value::pose() const {
  const std::vector<Value> values = items(3);
  return {{values[0].number(kCoordinate), values[1].number(kCoordinate)},
          radians(values[2].number(kAngle_deg))};
}

}  // namespace scanbed::scenarios
