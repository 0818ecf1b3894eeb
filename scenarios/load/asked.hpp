// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/load/node.hpp"

namespace scanbed::scenarios {

/// The numbers that a key allows: [least, greatest], or (least, greatest] where `open`.
struct Allowed {
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
  bool open = false;  ///< `least` itself is not allowed
};

/// What readers asked of one value of a file, over all the times that it was read: forms that it may have. So
/// the code that reads a key is the only place that says what the key is; the schema is drawn from it.
class Asked {
 public:
  enum class Form { kNumber, kCount, kFlag, kText, kWord, kList, kMap };

  /// The key of a map, made where it is new; in the order in which they were asked for.
  Asked& key(std::string_view name);
  /// Any element of a list.
  Asked& item();
  /// The value of any key of a map whose keys are free to choose.
  Asked& any_key();

  void add_number(Form form, const Allowed& allowed);  ///< kNumber or kCount
  void add_form(Form form) { forms_.insert(form); }
  void add_words(const std::vector<std::string>& words);
  /// A list of `least` elements or more.
  void add_list(std::size_t least, std::size_t greatest);
  /// A map of which all keys were read, these among them as ones that must be there.
  void add_whole_map(const std::set<std::string>& needed);

  const std::set<Form>& forms() const { return forms_; }
  bool has(Form form) const { return forms_.count(form) > 0; }
  const Allowed& allowed() const { return *allowed_; }  ///< the widest. @pre has a number or count
  const std::vector<std::string>& words() const { return words_; }
  std::size_t least_items() const { return least_items_; }
  std::size_t greatest_items() const { return greatest_items_; }
  bool is_needed(const std::string& key) const;  ///< whenever the map was read as a whole
  const std::vector<std::string>& key_names() const { return key_names_; }
  const Asked& key(std::string_view name) const { return *keys_.at(std::string(name)); }
  const Asked* items() const { return item_.get(); }
  const Asked* any_keys() const { return any_key_.get(); }

 private:
  std::set<Form> forms_;
  std::optional<Allowed> allowed_;
  std::vector<std::string> words_;
  std::size_t least_items_ = std::numeric_limits<std::size_t>::max();
  std::size_t greatest_items_ = 0;
  std::map<std::string, std::unique_ptr<Asked>> keys_;
  std::vector<std::string> key_names_;
  std::unique_ptr<Asked> item_;
  std::unique_ptr<Asked> any_key_;
  std::map<std::string, int> num_needed_;
  int num_whole_ = 0;
};

/// The last thing that a reader asked, where it then refused: what it stumbled over.
struct Question {
  const TreeNode* node = nullptr;
  Asked* asked = nullptr;
  Asked::Form form = Asked::Form::kText;
  std::string missing_key = {};  ///< of the map `node`; empty where it is the node itself that may not fit
  Allowed allowed = {};          ///< of a number: narrower than what `asked` has gathered where lists mix
};

/// Takes note of all questions while a tree is read.
struct AskedRecorder {
  Asked root;
  Question last;
};

/// Where questions about a value are noted; nowhere by default.
struct Notes {
  AskedRecorder* recorder = nullptr;
  Asked* asked = nullptr;

  Notes of_key(std::string_view name) const { return asked ? Notes{recorder, &asked->key(name)} : Notes{}; }
  Notes of_any_key() const { return asked ? Notes{recorder, &asked->any_key()} : Notes{}; }
  Notes of_item() const { return asked ? Notes{recorder, &asked->item()} : Notes{}; }
};

}  // namespace scanbed::scenarios
