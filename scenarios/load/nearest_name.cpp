// SPDX-License-Identifier: MIT
#include "scenarios/load/nearest_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <vector>

namespace scanbed::scenarios {
namespace {

// No known name is longer; a word beyond it is far from all of them, and its cost stays bounded.
constexpr std::size_t kLongestWord = 64;

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<int> before_last(width);
  std::vector<int> last(width);
  std::vector<int> row(width);
  std::iota(last.begin(), last.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> known) {
  if (word.size() > kLongestWord) return std::nullopt;
  const auto is_same_but_for_case = [word](const std::string& name) {
    return std::equal(word.begin(), word.end(), name.begin(), name.end(),
                      [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
  };
  const auto same = std::find_if(known.begin(), known.end(), is_same_but_for_case);
  if (same != known.end()) return *same;
  int best = std::max(1, static_cast<int>(word.size()) / 3) + 1;
  std::optional<std::string> nearest;
  for (const std::string& name : known) {
    const int distance = edit_distance(word, name);
    if (distance < best) {
      best = distance;
      nearest = name;
    }
  }
  return nearest;
}

std::string near_name_hint(std::string_view word, std::span<const std::string> known) {
  const std::optional<std::string> nearest = nearest_name(word, known);
  return nearest ? fmt::format("; did you mean '{}'?", *nearest) : "";
}

std::string name_hint(std::string_view word, std::span<const std::string> known, std::string_view what) {
  if (std::string hint = near_name_hint(word, known); !hint.empty()) return hint;
  if (known.empty()) return fmt::format("; there are no known {}", what);
  return fmt::format("; known {}: {}", what, fmt::join(known, ", "));
}

}  // namespace scanbed::scenarios
