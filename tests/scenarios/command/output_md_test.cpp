// SPDX-License-Identifier: MIT
// What is printed, against what scenarios/OUTPUT.md says of it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "tests/scenarios/run_program.hpp"

namespace scanbed::scenarios {
namespace {

// At any depth.
void collect_keys(const nlohmann::json& json, std::set<std::string>& keys) {
  for (const auto& [key, value] : json.items()) {
    if (json.is_object()) keys.insert(key);
    if (value.is_structured()) collect_keys(value, keys);
  }
}

TEST(OutputMdTest, NamesEveryKeyThatIsPrinted) {
  std::set<std::string> keys;
  const testing::Outcome features = testing::run_program(
      {"detect", "--laser", "sim:static_hallway", "--track", "--interpret", "--limit", "60"});
  std::istringstream lines(features.out);
  for (std::string line; std::getline(lines, line);) collect_keys(nlohmann::json::parse(line), keys);
  const testing::Outcome run =
      testing::run_program({"run", "crowd", "dark_and_glass", "--track", "--json", "-"});
  collect_keys(nlohmann::json::parse(run.out), keys);
  ASSERT_GE(keys.size(), 60u);
  const std::string text = testing::read_file(SCANBED_SOURCE_DIR "/scenarios/OUTPUT.md");
  for (const std::string& key : keys) EXPECT_NE(text.find("`" + key + "`"), std::string::npos) << key;
}

}  // namespace
}  // namespace scanbed::scenarios
