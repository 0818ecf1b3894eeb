// SPDX-License-Identifier: MIT
#include "scenarios/load/expect.hpp"

#include <fmt/format.h>

#include <cmath>

namespace scanbed::scenarios {
namespace {

std::string count_text(const ScanCondition& condition) {
  const bool is_bounded = condition.at_most != std::numeric_limits<int>::max();
  if (is_bounded && condition.at_least == 0) return fmt::format(", at most {}", condition.at_most);
  if (is_bounded && condition.at_least == condition.at_most) return fmt::format(", {}", condition.at_least);
  if (is_bounded) return fmt::format(", {} to {}", condition.at_least, condition.at_most);
  return condition.at_least > 0 ? fmt::format(", at least {}", condition.at_least) : "";
}

}  // namespace

std::string_view to_string(ExpectedKind kind) {
  return std::visit([](auto of) { return to_string(of); }, kind);
}

std::string Expectation::text() const {
  std::string text = std::string(to_string(condition.kind)) + count_text(condition);
  if (condition.near)
    text += fmt::format(" within {:g} m of {}", condition.near->within_m, condition.near->id);
  if (condition.recall) text += fmt::format(", recall >= {:g}", *condition.recall);
  if (condition.precision) text += fmt::format(", precision >= {:g}", *condition.precision);
  if (share == 0.0) {
    text += ", in one scan";
  } else {
    text += share == 1.0 ? ", in all scans" : fmt::format(", in {:g} % of the scans", 100.0 * share);
  }
  return window.is_whole() ? text : text + " of " + to_string(window);
}

}  // namespace scanbed::scenarios
