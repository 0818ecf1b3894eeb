// SPDX-License-Identifier: MIT
#include "core/options/option_table.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/detect/table_two.hpp"
#include "core/errors/input_error.hpp"

namespace scanbed {
namespace {

AnalysisOptions robust() {
  AnalysisOptions options;
  options.detector = robust_options();
  return options;
}

TEST(OptionTableTest, NamesAreUniqueAndStandGroupByGroup) {
  std::set<std::string_view> paths;
  std::set<std::string_view> groups;
  std::string_view group;
  for (const Option& option : option_table()) {
    EXPECT_TRUE(paths.insert(option.path).second) << option.path;
    EXPECT_FALSE(option.effect.empty()) << option.path;
    if (option.group() == group) continue;
    group = option.group();
    EXPECT_TRUE(groups.insert(group).second) << group << " is in two places";
  }
}

TEST(OptionTableTest, EachOptionChangesAFieldOfItsOwn) {
  for (const Option& changed : option_table()) {
    AnalysisOptions options = robust();
    const double other = changed.get(options) == 1.0 ? 0.0 : 1.0;
    changed.set(options, other);
    EXPECT_EQ(changed.get(options), other) << changed.path;
    for (const Option& option : option_table()) {
      if (&option == &changed) continue;
      EXPECT_EQ(option.get(options), option.get(robust())) << changed.path << " changes " << option.path;
    }
  }
}

// The names in the table are those of the errors: a value that no option allows is refused by its name.
TEST(OptionTableTest, ValidationKnowsTheSameNames) {
  for (const Option& option : option_table()) {
    if (option.kind == OptionKind::kFlag) continue;
    AnalysisOptions options = robust();
    option.set(options, -1e6);
    try {
      options.validate();
      FAIL() << option.path << " accepts -1e6";
    } catch (const InputError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(std::string(option.path) + ":")) << error.what();
    }
  }
}

TEST(OptionTableTest, AChoiceIsAnyOfItsWordsAndNothingElse) {
  for (const Option& option : option_table()) {
    if (option.kind != OptionKind::kChoice) continue;
    AnalysisOptions options = robust();
    for (std::size_t i = 0; i < option.words.size(); ++i) {
      option.set(options, static_cast<double>(i));
      EXPECT_NO_THROW(options.validate()) << option.path;
      EXPECT_EQ(option.text(options), option.words[i]);
    }
    option.set(options, static_cast<double>(option.words.size()));
    EXPECT_THROW(options.validate(), InputError) << option.path;
  }
}

TEST(OptionTableTest, TellsWhetherAnOptionIsRead) {
  const auto is_read = [](std::string_view path, const AnalysisOptions& options) {
    return find_option(path)->is_read(options);
  };
  AnalysisOptions options = robust();
  EXPECT_TRUE(is_read("leg.min_score", options));
  EXPECT_TRUE(is_read("surface.arc_price", options));
  for (const char* path : {"line.max_error_m", "segmentation.min_points", "leg.max_width_m"}) {
    EXPECT_FALSE(is_read(path, options)) << path;
  }
  options.detector.leg.scorer = LegScorer::kRules;
  EXPECT_FALSE(is_read("line.max_error_m", options));
  EXPECT_TRUE(is_read("segmentation.min_points", options));
  EXPECT_TRUE(is_read("leg.max_width_m", options));
  options.detector = paper_options();
  options.detector.leg.scorer = LegScorer::kForest;
  EXPECT_FALSE(is_read("surface.arc_price", options));
  EXPECT_TRUE(is_read("segmentation.min_points", options));
  EXPECT_FALSE(is_read("leg.max_width_m", options));
}

TEST(OptionTableTest, UnitsFollowFromNames) {
  EXPECT_EQ(find_option("circle.max_std_rad")->unit(), "rad");
  EXPECT_EQ(find_option("track.gate_m")->unit(), "m");
  EXPECT_EQ(find_option("track.gate_speed_m_per_s")->unit(), "m/s");
  EXPECT_EQ(find_option("track.max_hidden_s")->unit(), "s");
  EXPECT_EQ(find_option("line.min_points")->unit(), "");
  EXPECT_EQ(find_option("line.min_pionts"), nullptr);
}

TEST(OptionTableTest, TextIsWhatFilesSay) {
  EXPECT_EQ(find_option("pipeline")->text(robust()), "robust");
  EXPECT_EQ(find_option("leg.enabled")->text(robust()), "true");
  EXPECT_EQ(find_option("line.min_points")->text(robust()), "5");
  EXPECT_EQ(find_option("track.gate_m")->text(robust()), "0.15");
}

TEST(OptionTableTest, TableTwoStandsForOptions) {
  for (const TableTwoEntry& entry : table_two()) {
    if (entry.name == "laser") continue;
    const Option* option = find_option(entry.option);
    ASSERT_NE(option, nullptr) << entry.name;
    AnalysisOptions options;
    const double before = option->get(options);
    set_table_two(options.detector, entry.name, entry.min_value);
    const double changed = option->get(options);
    set_table_two(options.detector, entry.name, entry.max_value);
    EXPECT_TRUE(before != changed || before != option->get(options)) << entry.name;
  }
}

}  // namespace
}  // namespace scanbed
