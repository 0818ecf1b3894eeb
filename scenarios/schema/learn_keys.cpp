// SPDX-License-Identifier: MIT
#include "scenarios/schema/learn_keys.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/errors/input_error.hpp"
#include "scenarios/load/number.hpp"

namespace scanbed::scenarios {
namespace {

using Form = Asked::Form;

/// The way to a value: names of keys, "[]" into any element of a list.
using Way = std::vector<std::string>;
using Values = std::vector<std::pair<Way, TreeNode>>;
const std::string kItem = "[]";
const std::string kAnyKey = "a";  // where keys are free to choose

TreeNode scalar(std::string text, bool is_quoted = false) {
  TreeNode node;
  node.kind = TreeNode::Kind::kScalar;
  node.text = std::move(text);
  node.is_quoted = is_quoted;
  return node;
}

TreeNode empty(TreeNode::Kind kind) {
  TreeNode node;
  node.kind = kind;
  return node;
}

/// Which numbers a tree gets.
enum class Numbers {
  kGreatest,  ///< bounds that depend on others are then as wide as they get
  kRising,    ///< each greater than the one before, for keys that must be
};

std::string number_text(const Allowed& allowed, double share, bool is_whole) {
  double value = 1.0;
  if (std::isfinite(allowed.greatest)) {
    const double least = std::isfinite(allowed.least) ? allowed.least : 0.0;
    value = least + share * (allowed.greatest - least);
  } else if (std::isfinite(allowed.least)) {
    value = allowed.least + share;
  }
  if (is_whole) value = std::ceil(value);
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

class Learner {
 public:
  explicit Learner(const Reader& read) : read_(read) {}

  Asked learn() {
    for (std::size_t known = 0; known != size(recorder_.root);) {
      known = size(recorder_.root);
      explore({}, recorder_.root);
    }
    return std::move(recorder_.root);
  }

 private:
  static std::size_t size(const Asked& asked) {
    std::size_t sum = 1 + asked.forms().size() + asked.words().size();
    for (const std::string& key : asked.key_names()) sum += size(asked.key(key));
    if (asked.items() != nullptr) sum += size(*asked.items());
    if (asked.any_keys() != nullptr) sum += size(*asked.any_keys());
    return sum;
  }

  // Of words that reading adds to.
  static std::vector<std::string> copy_of(const std::vector<std::string>& words) { return words; }

  // Tries the value itself in all its forms, then its parts.
  void explore(const Way& way, const Asked& asked) {
    try_forms(way, asked);
    const std::vector<std::string> keys = copy_of(asked.key_names());
    for (const std::string& key : keys) explore(with(way, key), asked.key(key));
    for (const std::string& key : keys) try_beside(way, asked, key);
    if (asked.items() != nullptr) explore(with(way, kItem), *asked.items());
    if (asked.any_keys() != nullptr) explore(with(way, kAnyKey), *asked.any_keys());
  }

  static Way with(Way way, const std::string& step) {
    way.push_back(step);
    return way;
  }

  void try_forms(const Way& way, const Asked& asked) {
    const std::vector<std::string> words = copy_of(asked.words());
    for (const std::string& word : words) attempt({{way, scalar(word)}});
    attempt({{way, empty(TreeNode::Kind::kNothing)}});
    attempt({{way, scalar("1")}});
    attempt({{way, empty(TreeNode::Kind::kMap)}});
    TreeNode list = empty(TreeNode::Kind::kList);
    list.items.emplace_back();
    attempt({{way, list}});
  }

  // Keys that only go with another one, or mean something else beside it.
  void try_beside(const Way& way, const Asked& map, const std::string& key) {
    const std::vector<std::string> keys = copy_of(map.key_names());
    const std::vector<std::string> words = copy_of(map.key(key).words());
    for (const std::string& other : keys) {
      if (other == key) continue;
      const std::pair<Way, TreeNode> beside{with(way, other), empty(TreeNode::Kind::kNothing)};
      attempt({beside, {with(way, key), empty(TreeNode::Kind::kNothing)}});
      for (const std::string& word : words) attempt({{with(way, key), scalar(word)}, beside});
    }
  }

  // What was read once has nothing more to ask.
  void attempt(const Values& values) {
    const std::string name = name_of(values);
    if (done_.count(name) > 0) return;
    if (attempt(values, Numbers::kGreatest) || attempt(values, Numbers::kRising)) done_.insert(name);
  }

  static std::string name_of(const Values& values) {
    std::string name;
    for (const auto& [way, value] : values) {
      for (const std::string& step : way) name += step + '/';
      name += std::to_string(static_cast<int>(value.kind)) + value.text + '\n';
    }
    return name;
  }

  // Reads a tree that has these values and whatever else the reader insists on.
  bool attempt(const Values& values, Numbers numbers) {
    numbers_ = numbers;
    num_numbers_ = 0;
    TreeNode root = empty(TreeNode::Kind::kMap);
    for (const auto& [way, value] : values) place(root, way, value);
    if (numbers == Numbers::kGreatest) fill_in(root, recorder_.root);
    constexpr int kMostAnswers = 100;
    for (int i = 0; i < kMostAnswers; ++i) {
      recorder_.last = {};
      try {
        read_(root, recorder_);
        keep_examples(root, recorder_.root);
        return true;
      } catch (const InputError&) {
        if (!answer(root)) return false;
      }
    }
    return false;
  }

  static void place(TreeNode& root, const Way& way, const TreeNode& value) {
    TreeNode* node = &root;
    for (const std::string& step : way) {
      if (step == kItem) {
        node->kind = TreeNode::Kind::kList;
        if (node->items.empty()) node->items.emplace_back();
        node = &node->items.front();
        continue;
      }
      node->kind = TreeNode::Kind::kMap;
      const auto same = [&](const NodeEntry& entry) { return entry.key == step; };
      auto found = std::find_if(node->entries.begin(), node->entries.end(), same);
      if (found == node->entries.end()) found = node->entries.insert(found, {step, {}, {}});
      node = &found->value;
    }
    *node = value;
  }

  // Adds what is known to be insisted on: each question is a read that fails.
  void fill_in(TreeNode& node, const Asked& asked) const {
    if (node.kind != TreeNode::Kind::kMap) return;
    for (const std::string& key : asked.key_names()) {
      const auto has_key = [&](const NodeEntry& entry) { return entry.key == key; };
      const auto found = std::find_if(node.entries.begin(), node.entries.end(), has_key);
      if (found != node.entries.end()) {
        fill_in(found->value, asked.key(key));
      } else if (asked.is_needed(key)) {
        node.entries.push_back({key, {}, example(asked.key(key))});
      }
    }
  }

  // Gives the reader what it last asked for. @returns false where it had that already.
  bool answer(TreeNode& root) {
    const Question& last = recorder_.last;
    TreeNode* node = last.node == nullptr ? nullptr : find(root, last.node);
    if (node == nullptr) return false;
    if (!last.missing_key.empty()) {
      node->entries.push_back({last.missing_key, {}, example(last.asked->key(last.missing_key))});
      return true;
    }
    if (fits(*node, last)) return false;
    *node = sample(last);
    return true;
  }

  static TreeNode* find(TreeNode& node, const TreeNode* wanted) {
    if (&node == wanted) return &node;
    for (TreeNode& item : node.items) {
      if (TreeNode* found = find(item, wanted)) return found;
    }
    for (NodeEntry& entry : node.entries) {
      if (TreeNode* found = find(entry.value, wanted)) return found;
    }
    return nullptr;
  }

  static bool fits(const TreeNode& node, const Question& last) {
    if (last.form == Form::kMap) return node.kind == TreeNode::Kind::kMap;
    if (last.form == Form::kList) {
      return node.kind == TreeNode::Kind::kList && node.items.size() >= last.asked->least_items();
    }
    if (node.kind != TreeNode::Kind::kScalar) return false;
    const std::vector<std::string>& words = last.asked->words();
    if (last.form == Form::kWord) return std::find(words.begin(), words.end(), node.text) != words.end();
    if (last.form == Form::kNumber || last.form == Form::kCount) {
      const std::optional<double> number = parse_number(node.text);
      const Allowed& allowed = last.allowed;
      return number && *number >= allowed.least && *number <= allowed.greatest;
    }
    return last.form != Form::kFlag || node.text == "true";
  }

  TreeNode sample(const Question& last) {
    switch (last.form) {
      case Form::kNumber:
      case Form::kCount:
        return scalar(number_text(last.allowed, share_of_next_number(), last.form == Form::kCount));
      case Form::kFlag:
        return scalar("true");
      case Form::kText:
        return scalar("a", true);
      case Form::kWord:
        return scalar(last.asked->words().front());
      case Form::kMap:
        return example(*last.asked, TreeNode::Kind::kMap);
      case Form::kList: {
        TreeNode list = empty(TreeNode::Kind::kList);
        list.items.resize(std::max<std::size_t>(1, last.asked->least_items()));
        return list;
      }
    }
    return {};
  }

  // Thrice the one before, so that it is also more than twice that.
  double share_of_next_number() {
    if (numbers_ == Numbers::kGreatest) return 1.0;
    constexpr int kNumRising = 10;
    return std::pow(3.0, std::min(0, num_numbers_++ - kNumRising));
  }

  // A value that the reader took once, else one of this kind without content.
  TreeNode example(const Asked& asked, TreeNode::Kind kind = TreeNode::Kind::kNothing) const {
    const auto found = examples_.find(&asked);
    return found == examples_.end() ? empty(kind) : found->second;
  }

  void keep_examples(const TreeNode& node, Asked& asked) {
    const bool is_number_of_its_own = node.kind == TreeNode::Kind::kScalar && numbers_ == Numbers::kGreatest;
    if (node.kind == TreeNode::Kind::kMap || is_number_of_its_own) examples_.try_emplace(&asked, node);
    if (asked.any_keys() != nullptr) return;
    for (const NodeEntry& entry : node.entries) keep_examples(entry.value, asked.key(entry.key));
    for (const TreeNode& item : node.items) keep_examples(item, asked.item());
  }

  const Reader& read_;
  AskedRecorder recorder_;
  Numbers numbers_ = Numbers::kGreatest;
  int num_numbers_ = 0;  // in the tree so far
  std::map<const Asked*, TreeNode> examples_;
  std::set<std::string> done_;  // attempts that were read to their end
};

}  // namespace

Asked learn_keys(const Reader& read) {
  return Learner(read).learn();
}

}  // namespace scanbed::scenarios
