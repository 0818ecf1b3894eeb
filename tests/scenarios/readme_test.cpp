// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <sstream>
#include <vector>

#include "scenarios/load/load_scenario.hpp"
#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

struct Snippet {
  int line = 0;  // of the README
  std::string text;
};

std::vector<Snippet> yaml_snippets(const std::string& markdown) {
  std::vector<Snippet> snippets;
  std::istringstream lines(markdown);
  bool is_inside = false;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line == "```yaml") snippets.push_back({number, ""});
    if (line.starts_with("```")) {
      is_inside = line == "```yaml";
    } else if (is_inside) {
      snippets.back().text += line + "\n";
    }
  }
  return snippets;
}

TEST(ReadmeTest, EverySnippetLoads) {
  const std::string readme = testing::read_file(SCANBED_SOURCE_DIR "/scenarios/README.md");
  const std::vector<Snippet> snippets = yaml_snippets(readme);
  ASSERT_GE(snippets.size(), 12u);
  for (const Snippet& snippet : snippets) {
    const bool is_whole = snippet.text.starts_with("schema:");
    const std::string head = is_whole ? "" : "schema: 1\nname: snippet\nduration: 10\n";
    EXPECT_EQ(testing::error_of([&] { parse_scenario(head + snippet.text, "snippet"); }), "")
        << "README.md, line " << snippet.line;
  }
}

}  // namespace
}  // namespace scanbed::scenarios
