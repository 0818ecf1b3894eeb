// SPDX-License-Identifier: MIT
#include "scenarios/load/asked.hpp"

#include <algorithm>

namespace scanbed::scenarios {
namespace {

Asked& made(std::unique_ptr<Asked>& child) {
  if (!child) child = std::make_unique<Asked>();
  return *child;
}

}  // namespace

Asked& Asked::key(std::string_view name) {
  std::unique_ptr<Asked>& child = keys_[std::string(name)];
  if (!child) key_names_.emplace_back(name);
  return made(child);
}

Asked& Asked::item() {
  return made(item_);
}

Asked& Asked::any_key() {
  return made(any_key_);
}

void Asked::add_number(Form form, const Allowed& allowed) {
  add_form(form);
  if (!allowed_) allowed_ = allowed;
  if (allowed.least == allowed_->least) allowed_->open = allowed_->open && allowed.open;
  if (allowed.least < allowed_->least) {
    allowed_->least = allowed.least;
    allowed_->open = allowed.open;
  }
  allowed_->greatest = std::max(allowed_->greatest, allowed.greatest);
}

void Asked::add_words(const std::vector<std::string>& words) {
  add_form(Form::kWord);
  for (const std::string& word : words) {
    if (std::find(words_.begin(), words_.end(), word) == words_.end()) words_.push_back(word);
  }
}

void Asked::add_list(std::size_t least, std::size_t greatest) {
  add_form(Form::kList);
  least_items_ = std::min(least_items_, least);
  greatest_items_ = std::max(greatest_items_, greatest);
}

void Asked::add_whole_map(const std::set<std::string>& needed) {
  ++num_whole_;
  for (const std::string& key : needed) ++num_needed_[key];
}

bool Asked::is_needed(const std::string& key) const {
  const auto found = num_needed_.find(key);
  return found != num_needed_.end() && found->second == num_whole_;
}

}  // namespace scanbed::scenarios
