// SPDX-License-Identifier: MIT
#include "hw/recording/field_reader.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scanbed::hw {
namespace {

TEST(FieldReaderTest, BlanksAndTabsSeparateWords) {
  FieldReader fields(" one\t two  three ");
  EXPECT_EQ(fields.num_left(), 3);
  EXPECT_EQ(fields.word(), "one");
  EXPECT_EQ(fields.word(), "two");
  EXPECT_EQ(fields.num_left(), 1);
  EXPECT_EQ(fields.word(), "three");
  EXPECT_EQ(fields.num_left(), 0);
  EXPECT_EQ(fields.word(), "");
  EXPECT_TRUE(fields.ok());
}

TEST(FieldReaderTest, ReadsNumbersAsPrintfWritesThem) {
  FieldReader fields("1.5 -2 +3.25 1e-3 .5 7. 12E2");
  for (const double value : {1.5, -2.0, 3.25, 1e-3, 0.5, 7.0, 1200.0}) EXPECT_EQ(fields.number("x"), value);
  EXPECT_TRUE(fields.ok()) << fields.failure();
}

TEST(FieldReaderTest, NanAndInfinityAreNumbersButNotFinite) {
  FieldReader fields("nan -nan inf -inf INF Infinity");
  EXPECT_TRUE(std::isnan(fields.number("x")));
  EXPECT_TRUE(std::isnan(fields.number("x")));
  EXPECT_EQ(fields.number("x"), INFINITY);
  EXPECT_EQ(fields.number("x"), -INFINITY);
  EXPECT_EQ(fields.number("x"), INFINITY);
  EXPECT_TRUE(fields.ok());
  EXPECT_EQ(fields.finite("theta"), INFINITY);
  EXPECT_EQ(fields.failure(), "theta is not finite");
}

TEST(FieldReaderTest, TimesAreOfClocksThatThereAre) {
  for (const char* text : {"1e12", "-1e12", "0", "1700000000.5"}) {
    FieldReader fields(text);
    fields.time("time");
    EXPECT_TRUE(fields.ok()) << text;
  }
  for (const char* text : {"1.1e12", "-1e308"}) {
    FieldReader fields(text);
    fields.time("time");
    EXPECT_EQ(fields.failure(), "time is more than 1e12 s away from 0") << text;
  }
  FieldReader fields("nan");
  fields.time("time");
  EXPECT_EQ(fields.failure(), "time is not finite");
}

TEST(FieldReaderTest, RefusesWhatIsNoNumber) {
  for (const char* text : {"abc", "1.5x", "0x10", "1,5", "--1", "+-1", "+", "-", "1e999", "1.2.3"}) {
    FieldReader fields(text);
    EXPECT_TRUE(std::isnan(fields.number("speed"))) << text;
    EXPECT_EQ(fields.failure(), "speed is '" + std::string(text) + "', not a number");
  }
}

TEST(FieldReaderTest, NamesAMissingField) {
  FieldReader number(" ");
  number.number("speed");
  EXPECT_EQ(number.failure(), "speed is missing");
  FieldReader count("");
  EXPECT_EQ(count.count("num"), 0);
  EXPECT_EQ(count.failure(), "num is missing");
}

TEST(FieldReaderTest, ReadsCounts) {
  FieldReader fields("0 361 2147483647");
  EXPECT_EQ(fields.count("num"), 0);
  EXPECT_EQ(fields.peek_count(), 361);
  EXPECT_EQ(fields.count("num"), 361);
  EXPECT_EQ(fields.count("num"), 2147483647);
  EXPECT_TRUE(fields.ok());
}

TEST(FieldReaderTest, RefusesWhatIsNoCount) {
  for (const char* text : {"-1", "2147483648", "1e9", "3.0", "x", "99999999999999999999"}) {
    FieldReader fields(text);
    EXPECT_EQ(fields.peek_count(), std::nullopt);
    EXPECT_TRUE(fields.ok()) << "looking ahead must not fail";
    EXPECT_EQ(fields.count("num"), 0);
    EXPECT_EQ(fields.failure(), "num is '" + std::string(text) + "', not a count");
  }
}

TEST(FieldReaderTest, TheFirstFailureSticks) {
  FieldReader fields("x y");
  fields.number("first");
  fields.number("second");
  EXPECT_EQ(fields.failure(), "first is 'x', not a number");
}

TEST(FieldReaderTest, MessagesStayShortAndPrintable) {
  const std::string field = "\x1b[31m" + std::string(1000, 'x');
  FieldReader fields(field);
  fields.number("speed");
  EXPECT_EQ(fields.failure(), "speed is '?[31m" + std::string(27, 'x') + "...', not a number");
}

}  // namespace
}  // namespace scanbed::hw
