// SPDX-License-Identifier: MIT
#include "scenarios/load/asked.hpp"

#include <gtest/gtest.h>

#include "scenarios/load/table.hpp"
#include "scenarios/load/yaml.hpp"
#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

using Form = Asked::Form;

void read(const Value& value) {
  Table table(value);
  table.need("a").number({.least = 1.0, .greatest = 3.0});
  if (const auto b = table.take("b")) b->points_m(2);
  table.flag("c", false);
  table.finish();
}

AskedRecorder noted(const std::string& text) {
  AskedRecorder recorder;
  const TreeNode root = parse_yaml(text, "f");
  const Variables none;
  testing::error_of([&] { read(Value(root, "r", none, {&recorder, &recorder.root})); });
  return recorder;
}

TEST(AskedTest, NotesKeysInTheOrderOfTheQuestions) {
  const AskedRecorder recorder = noted("{c: true, b: [[1, 2], [3, 4]], a: 2}");
  const Asked& asked = recorder.root;
  EXPECT_EQ(asked.key_names(), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_TRUE(asked.is_needed("a"));
  EXPECT_FALSE(asked.is_needed("b"));
  EXPECT_EQ(asked.key("a").allowed().greatest, 3.0);
  EXPECT_TRUE(asked.key("c").has(Form::kFlag));
  EXPECT_EQ(asked.key("b").least_items(), 2u);
  const Asked& point = *asked.key("b").items();
  EXPECT_EQ(point.greatest_items(), 2u);
  EXPECT_TRUE(point.items()->has(Form::kNumber));
}

TEST(AskedTest, TheLastQuestionIsTheOneThatWasNotAnswered) {
  EXPECT_EQ(noted("{c: true}").last.missing_key, "a");
  const AskedRecorder recorder = noted("{a: 2, b: 7}");
  EXPECT_TRUE(recorder.last.missing_key.empty());
  EXPECT_EQ(recorder.last.form, Form::kList);
  EXPECT_EQ(recorder.last.asked, &recorder.root.key("b"));
}

TEST(AskedTest, RangesWiden) {
  Asked asked;
  asked.add_number(Form::kNumber, {.least = 0.0, .greatest = 1.0, .open = true});
  asked.add_number(Form::kCount, {.least = 0.0, .greatest = 5.0});
  EXPECT_FALSE(asked.allowed().open);
  asked.add_number(Form::kNumber, {.least = -1.0, .greatest = 2.0, .open = true});
  EXPECT_EQ(asked.allowed().least, -1.0);
  EXPECT_TRUE(asked.allowed().open);
  EXPECT_EQ(asked.allowed().greatest, 5.0);
}

TEST(AskedTest, WhatIsNotAlwaysNeededIsNot) {
  Asked asked;
  asked.add_whole_map({"a", "b"});
  asked.add_whole_map({"a"});
  EXPECT_TRUE(asked.is_needed("a"));
  EXPECT_FALSE(asked.is_needed("b"));
}

}  // namespace
}  // namespace scanbed::scenarios
