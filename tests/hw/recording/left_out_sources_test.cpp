// SPDX-License-Identifier: MIT
#include "hw/recording/left_out_sources.hpp"

#include <gtest/gtest.h>

namespace scanbed::hw {
namespace {

TEST(LeftOutSourcesTest, NamesTheFilterAndWhatThereIsInstead) {
  LeftOutSources sources;
  EXPECT_EQ(sources.text(""), "");
  EXPECT_EQ(sources.text("c"), " with only=c");
  for (const char* name : {"b", "a", "b", ""}) sources.add(name);
  EXPECT_EQ(sources.text("c"), " with only=c; it has scans of a source without name, a, b");
}

TEST(LeftOutSourcesTest, NamesWhatCannotBeRead) {
  LeftOutSources sources;
  sources.add_unread("x/LaserScan in ros1");
  EXPECT_EQ(sources.text(""), "; not read: x/LaserScan in ros1");
}

TEST(LeftOutSourcesTest, StaysAMessageWhateverTheNames) {
  LeftOutSources sources;
  for (int i = 0; i < 1000; ++i) sources.add(std::to_string(i) + std::string(10'000, 'x'));
  EXPECT_LT(sources.text("c").size(), 2000U);
}

}  // namespace
}  // namespace scanbed::hw
