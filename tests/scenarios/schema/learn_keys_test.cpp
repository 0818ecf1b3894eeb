// SPDX-License-Identifier: MIT
#include "scenarios/schema/learn_keys.hpp"

#include <gtest/gtest.h>

#include <array>

#include "scenarios/load/load_scenario.hpp"
#include "scenarios/load/table.hpp"

namespace scanbed::scenarios {
namespace {

using Form = Asked::Form;

// A small language with all that makes learning hard: keys that exclude each other, keys that go with another
// one only, words that change what is asked, a list or a single value, free names.
void read_toy(const TreeNode& root, AskedRecorder& recorder) {
  static const std::array<std::string, 2> kKinds = {"plain", "fancy"};
  const Variables none;
  Table table(Value(root, "toy", none, {&recorder, &recorder.root}));
  const bool is_fancy = table.need("kind").choice(kKinds) == 1;
  if (const auto names = table.take("names")) {
    for (const Value& value : Table(*names).take_all()) value.flag();
  }
  const auto round = table.take("round");
  const auto square = table.take("square");
  if (round && square) square->refuse("one of round and square");
  if (const auto hat = table.take("hat")) {
    if (!round) hat->refuse("goes with round");
    hat->text();
  }
  if (is_fancy) {
    if (const auto frill = table.take("frill")) frill->number({.least = 0.0, .greatest = 9.0});
  }
  table.finish();
  if (!round && !square) table.value().refuse("one of round and square");
  if (square) {
    Table inner(*square);
    inner.need("side").number({.least = 1.0});
    inner.finish();
  }
  if (round) round->points_m(3);
}

TEST(LearnKeysTest, FindsAllThatAReaderMayAsk) {
  const Asked toy = learn_keys(read_toy);
  EXPECT_EQ(toy.key_names(), (std::vector<std::string>{"kind", "names", "round", "square", "hat", "frill"}));
  EXPECT_TRUE(toy.is_needed("kind"));
  EXPECT_EQ(toy.key("kind").words(), (std::vector<std::string>{"plain", "fancy"}));
  ASSERT_NE(toy.key("names").any_keys(), nullptr);
  EXPECT_TRUE(toy.key("names").any_keys()->has(Form::kFlag));
  EXPECT_EQ(toy.key("round").least_items(), 3u);
  EXPECT_TRUE(toy.key("square").is_needed("side"));
  EXPECT_TRUE(toy.key("hat").has(Form::kText));
  EXPECT_EQ(toy.key("frill").allowed().greatest, 9.0);
}

// Counts the values of which nothing was asked: none may be left.
int num_unread(const Asked& asked, const std::string& way) {
  int num = asked.forms().empty() ? 1 : 0;
  if (num > 0) ADD_FAILURE() << "nothing is known of " << way;
  for (const std::string& key : asked.key_names()) num += num_unread(asked.key(key), way + "." + key);
  if (asked.items() != nullptr) num += num_unread(*asked.items(), way + "[]");
  if (asked.any_keys() != nullptr) num += num_unread(*asked.any_keys(), way + ".*");
  return num;
}

TEST(LearnKeysTest, KnowsEveryKeyOfScenarioFiles) {
  const Asked scenario = learn_keys(read_scenario);
  EXPECT_EQ(num_unread(scenario, "scenario"), 0);
  // One from the depth of each section, where what is above must be right for it to be asked at all.
  const Asked& actor = *scenario.key("actors").items();
  EXPECT_EQ(actor.key("clothing").words(), (std::vector<std::string>{"bare", "trousers", "skirt"}));
  EXPECT_TRUE(actor.key("stops").items()->key("for").has(Form::kWord));
  EXPECT_TRUE(actor.key("stops").items()->key("for").has(Form::kNumber));
  EXPECT_TRUE(actor.key("tows").key("material").has(Form::kWord));
  EXPECT_TRUE(actor.key("tows").key("material").has(Form::kMap));
  EXPECT_TRUE(actor.key("tows").key("cylinder").is_needed("r"));
  EXPECT_TRUE(scenario.key("world").items()->key("feet").is_needed("apart"));
  EXPECT_TRUE(scenario.key("world").items()->key("seat_z").has(Form::kNumber));
  EXPECT_TRUE(scenario.key("world").items()->key("map").has(Form::kText));
  EXPECT_TRUE(scenario.key("score").key("person").key("need").key("mota").has(Form::kNumber));
  EXPECT_TRUE(scenario.key("score").key("leg").key("need").has(Form::kList));
  EXPECT_TRUE(scenario.key("expect").items()->key("circle").key("near").has(Form::kText));
  EXPECT_TRUE(scenario.key("sensor").key("bias").key("cyclic_period").has(Form::kNumber));
  EXPECT_EQ(scenario.key("outputs").key("pictures").key("top").items()->allowed().greatest, 86'400.0);
  EXPECT_TRUE(scenario.key("robot").key("drive").items()->key("follow").key("patience").has(Form::kNumber));
  EXPECT_TRUE(scenario.key("include").has(Form::kList));
  EXPECT_TRUE(scenario.key("vars").any_keys()->has(Form::kNumber));
}

}  // namespace
}  // namespace scanbed::scenarios
