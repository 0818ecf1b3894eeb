// SPDX-License-Identifier: MIT
#include "hw/recording/text_fields.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scanbed::hw {
namespace {

TEST(TextFieldsTest, FieldsAreAsShortAsTheyCanBe) {
  std::string out = "x";
  append_field(out, 0.1);
  append_field(out, 361);
  append_field(out, std::string_view("host"));
  append_field(out, HUGE_VAL);
  append_field(out, std::nan(""));
  EXPECT_EQ(out, "x 0.1 361 host inf nan");
}

TEST(TextFieldsTest, FixedFieldsAreAsPrintfs) {
  std::string out;
  append_fixed(out, 1.2345, 3);
  append_fixed(out, 2.0, 3);
  append_fixed(out, -0.5, 0);
  EXPECT_EQ(out, " 1.234 2.000 -0");
  append_fixed(out, 1e308, 3);
  EXPECT_EQ(out.size(), 15U + 1U + 309U + 4U);
}

TEST(TextFieldsTest, MetadataIsOneLine) {
  EXPECT_EQ(metadata_text({{"a", "x\ny"}, {"b", "\""}}), R"({"a":"x\u000ay","b":"\""})");
  EXPECT_EQ(metadata_text({}), "{}");
}

}  // namespace
}  // namespace scanbed::hw
