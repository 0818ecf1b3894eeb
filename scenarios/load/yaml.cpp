// SPDX-License-Identifier: MIT
#include "scenarios/load/yaml.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "core/errors/input_error.hpp"
#include "core/text/utf8.hpp"
#include "scenarios/load/node.hpp"

namespace scanbed::scenarios {
namespace {

// Builds our tree from the parser's events. The library's own tree keeps the first of duplicate keys, shares
// aliased nodes however often they are repeated, and forgets where missing things should have been.
class TreeBuilder final : public YAML::EventHandler {
 public:
  TreeBuilder(std::shared_ptr<const Source> source, const YamlLimits& limits)
      : source_(std::move(source)), limits_(limits) {}

  TreeNode take_root() { return std::move(root_); }
  /// Where the last scalar is one in quotes: its place.
  const std::optional<Place>& last_quotation() const { return last_quotation_; }
  Place place(const YAML::Mark& mark) const { return {source_, mark.line + 1, mark.column + 1}; }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    last_quotation_.reset();
    TreeNode node;
    node.place = place(mark);
    finish(std::move(node), anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) refuse(place(mark), "an alias within its own anchor");
    num_nodes_ += count_nodes(found->second);
    check_size(place(mark));
    add(found->second, place(mark));
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    // The parser marks a plain scalar with "?" and one in quotes with "!".
    if (!tag.empty() && tag != "?" && tag != "!") refuse(place(mark), "tags are not supported");
    // Names go into JSON and XML, which must be UTF-8.
    if (as_utf8(value) != value) refuse(place(mark), "is no text in UTF-8; save the file as UTF-8");
    TreeNode node;
    node.kind = TreeNode::Kind::kScalar;
    node.place = place(mark);
    node.text = value;
    node.is_quoted = tag == "!";
    last_quotation_ = node.is_quoted ? std::optional(node.place) : std::nullopt;
    finish(std::move(node), anchor);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open({TreeNode::Kind::kList, anchor, tag}, place(mark));
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open({TreeNode::Kind::kMap, anchor, tag}, place(mark));
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override { close(); }

 private:
  struct Opening {
    TreeNode::Kind kind;
    YAML::anchor_t anchor;
    const std::string& tag;
  };

  // A list or map whose end has not come yet.
  struct Unfinished {
    TreeNode node;
    YAML::anchor_t anchor = 0;
    std::optional<std::pair<std::string, Place>> key;  // of a map: waits for its value
    std::map<std::string, int> line_of_key;
  };

  void open(const Opening& opening, const Place& where) {
    if (!opening.tag.empty() && opening.tag != "?") refuse(where, "tags are not supported");
    if (stack_.size() >= static_cast<std::size_t>(limits_.max_depth)) {
      refuse(where, fmt::format("nested too deeply; allowed: {} levels", limits_.max_depth));
    }
    Unfinished unfinished;
    unfinished.node.kind = opening.kind;
    unfinished.node.place = where;
    unfinished.anchor = opening.anchor;
    stack_.push_back(std::move(unfinished));
  }

  void close() {
    Unfinished done = std::move(stack_.back());
    stack_.pop_back();
    finish(std::move(done.node), done.anchor);
  }

  void finish(TreeNode node, YAML::anchor_t anchor) {
    ++num_nodes_;
    check_size(node.place);
    if (anchor != 0) anchors_[anchor] = node;
    const Place where = node.place;
    add(std::move(node), where);
  }

  void add(TreeNode node, const Place& where) {
    if (stack_.empty()) {
      root_ = std::move(node);
    } else if (Unfinished& parent = stack_.back(); parent.node.kind == TreeNode::Kind::kList) {
      parent.node.items.push_back(std::move(node));
    } else if (parent.key) {
      parent.node.entries.push_back({parent.key->first, parent.key->second, std::move(node)});
      parent.key.reset();
    } else {
      add_key(parent, node, where);
    }
  }

  static void add_key(Unfinished& parent, const TreeNode& node, const Place& where) {
    if (node.kind != TreeNode::Kind::kScalar) refuse(where, "a key must be plain text");
    const auto [first, is_new] = parent.line_of_key.emplace(node.text, where.line);
    if (!is_new) {
      refuse(where, fmt::format("duplicate key {}; first on line {}", quote(node.text), first->second));
    }
    parent.key.emplace(node.text, where);
  }

  void check_size(const Place& where) const {
    if (num_nodes_ <= limits_.max_nodes) return;
    refuse(where, fmt::format("too many values; allowed: {}, aliases expanded", limits_.max_nodes));
  }

  std::shared_ptr<const Source> source_;
  YamlLimits limits_;
  TreeNode root_;
  std::optional<Place> last_quotation_;
  std::vector<Unfinished> stack_;
  std::map<YAML::anchor_t, TreeNode> anchors_;
  std::size_t num_nodes_ = 0;
};

[[noreturn]] void refuse_size(const std::string& source, const YamlLimits& limits) {
  throw InputError(fmt::format("{}: file is too large; allowed: {} KiB", source, limits.max_bytes / 1024));
}

std::string read_text(const std::filesystem::path& path, const YamlLimits& limits) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError(path.string() + ": no such file");
  if (std::filesystem::is_directory(status)) throw InputError(path.string() + ": is a folder, not a file");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
  // Bounded, so that /dev/zero ends as well; one byte more than allowed shows that there is more.
  std::string text(limits.max_bytes + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (file.bad()) throw InputError(path.string() + ": cannot be read to its end");
  return text;
}

// The parser takes the end of a file for that of an open quotation; the end of a document it does not.
void check_end(std::string_view text, const Place& quotation, const YamlLimits& limits) {
  std::istringstream stream{std::string(text) + "\n...\n"};
  TreeBuilder builder(quotation.source, limits);
  try {
    YAML::Parser(stream).HandleNextDocument(builder);
  } catch (const YAML::Exception&) {
    refuse(quotation, "not valid YAML: the quotation that begins here has no end");
  }
}

TreeNode parse(std::string_view text, const std::shared_ptr<const Source>& source, const YamlLimits& limits) {
  if (text.size() > limits.max_bytes) refuse_size(source->name, limits);
  std::istringstream stream{std::string(text)};
  TreeBuilder builder(source, limits);
  try {
    YAML::Parser parser(stream);
    parser.HandleNextDocument(builder);
    TreeNode root = builder.take_root();
    TreeBuilder second(source, limits);
    if (parser.HandleNextDocument(second)) {
      refuse(second.take_root().place, "a second document; a file holds one");
    }
    if (builder.last_quotation()) check_end(text, *builder.last_quotation(), limits);
    return root;
  } catch (const YAML::Exception& error) {
    refuse(builder.place(error.mark), "not valid YAML: " + error.msg);
  }
}

}  // namespace

TreeNode parse_yaml(std::string_view text, const std::string& source, const YamlLimits& limits) {
  return parse(text, std::make_shared<const Source>(Source{source}), limits);
}

TreeNode read_yaml(const std::filesystem::path& path, const YamlLimits& limits) {
  // "./" where the path is a bare name: a folder that is empty is none.
  const Source source{path.string(), "." / path.parent_path()};
  return parse(read_text(path, limits), std::make_shared<const Source>(source), limits);
}

}  // namespace scanbed::scenarios
