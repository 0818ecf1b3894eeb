// SPDX-License-Identifier: MIT
#include "scenarios/load/value.hpp"

#include <gtest/gtest.h>

#include <array>

#include "scenarios/load/yaml.hpp"
#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

// The value of key "k" in "k: <text>", which stands in column 4.
class Written {
 public:
  explicit Written(const std::string& text) : root_(parse_yaml("k: " + text + "\n", "f")) {}
  Value value() const { return {root_.entries[0].value, "k", variables_}; }

  template <typename Read>
  std::string error(Read&& read) const {
    return testing::error_of([&] { read(value()); });
  }

 private:
  TreeNode root_;
  Variables variables_ = {{"R", 0.25}};
};

std::string number_error(const std::string& text, const Allowed& allowed = {}) {
  return Written(text).error([&](const Value& value) { value.number(allowed); });
}

TEST(ValueTest, ReadsNumbersAndVariables) {
  EXPECT_EQ(Written("-1.5").value().number(), -1.5);
  EXPECT_EQ(Written("$R").value().number(), 0.25);
  EXPECT_EQ(Written("-$R").value().number(), -0.25);
}

TEST(ValueTest, RefusesWhatIsNoNumber) {
  EXPECT_EQ(number_error("012"), "f:1:4: k: expected a number, found '012'");
  EXPECT_EQ(number_error(".nan"), "f:1:4: k: expected a number, found '.nan'");
  EXPECT_EQ(number_error("'1'"), "f:1:4: k: expected a number, found '1'");
  EXPECT_EQ(number_error("[1]"), "f:1:4: k: expected a number, found a list");
  EXPECT_EQ(number_error("{a: 1}"), "f:1:4: k: expected a number, found a map");
  EXPECT_NE(number_error("").find("k: expected a number, found nothing"), std::string::npos);
  EXPECT_EQ(number_error("$r"), "f:1:4: k: unknown variable 'r'; did you mean 'R'?");
}

TEST(ValueTest, RefusesNumbersOutOfRange) {
  EXPECT_EQ(number_error("0", kLength), "f:1:4: k: value 0 is out of range; allowed: (0, 1000]");
  EXPECT_EQ(number_error("-1", {.least = 0.0}), "f:1:4: k: value -1 is out of range; allowed: >= 0");
  EXPECT_EQ(number_error("0", {.least = 0.0, .open = true}),
            "f:1:4: k: value 0 is out of range; allowed: > 0");
  EXPECT_EQ(number_error("3", {.greatest = 2.0}), "f:1:4: k: value 3 is out of range; allowed: <= 2");
  EXPECT_EQ(number_error("$R", {.least = 1.0, .greatest = 2.0}),
            "f:1:4: k: value 0.25 is out of range; allowed: [1, 2]");
  EXPECT_EQ(number_error("2", {.least = 1.0, .greatest = 2.0}), "");
}

TEST(ValueTest, ReadsEveryWholeNumberExactly) {
  // 2^53 + 1 has no double.
  EXPECT_EQ(Written("9007199254740993").value().count(), 9007199254740993);
  const auto count_error = [](const std::string& text) {
    return Written(text).error([](const Value& value) { value.count({.least = 0.0}); });
  };
  EXPECT_EQ(count_error("1.5"), "f:1:4: k: expected a whole number, found 1.5");
  EXPECT_EQ(count_error("-2"), "f:1:4: k: value -2 is out of range; allowed: >= 0");
  EXPECT_EQ(count_error("x"), "f:1:4: k: expected a whole number, found 'x'");
}

TEST(ValueTest, ReadsFlagsInOneSpelling) {
  EXPECT_TRUE(Written("true").value().flag());
  EXPECT_FALSE(Written("false").value().flag());
  for (const std::string text : {"no", "yes", "1", "True", "'true'"}) {
    EXPECT_NE(Written(text).error([](const Value& value) { value.flag(); }), "") << text;
  }
}

TEST(ValueTest, ReadsTextAndWords) {
  static const std::array<std::string, 2> kUnits = {"mm", "cm"};
  EXPECT_EQ(Written("'a b'").value().text(), "a b");
  EXPECT_EQ(Written("cm").value().choice(kUnits), 1u);
  EXPECT_EQ(Written("''").error([](const Value& value) { value.text(); }),
            "f:1:4: k: expected text, found nothing");
  EXPECT_EQ(Written("m").error([](const Value& value) { value.choice(kUnits); }),
            "f:1:4: k: unknown value 'm'; did you mean 'mm'?");
}

TEST(ValueTest, ReadsPointsAndPoses) {
  EXPECT_EQ(Written("[1, $R]").value().point_m(), Eigen::Vector2d(1.0, 0.25));
  const Pose2 pose = Written("[1, 2, 90]").value().pose();
  EXPECT_EQ(pose.p_m, Eigen::Vector2d(1.0, 2.0));
  EXPECT_DOUBLE_EQ(pose.theta_rad, kPi / 2);
  EXPECT_EQ(Written("[[0, 0], [1, 0]]").value().points_m(2).size(), 2u);
}

TEST(ValueTest, RefusesPointsOfAnotherShape) {
  EXPECT_EQ(Written("[1]").error([](const Value& value) { value.point_m(); }),
            "f:1:4: k: expected 2 values, found 1");
  EXPECT_EQ(Written("[1, 2]").error([](const Value& value) { value.pose(); }),
            "f:1:4: k: expected 3 values, found 2");
  EXPECT_EQ(Written("3").error([](const Value& value) { value.items(); }),
            "f:1:4: k: expected a list, found a single value");
  EXPECT_EQ(Written("[[0, 0]]").error([](const Value& value) { value.points_m(2); }),
            "f:1:4: k: expected at least 2 points, found 1");
  EXPECT_EQ(Written("[0, 1001]").error([](const Value& value) { value.point_m(); }),
            "f:1:8: k: value 1001 is out of range; allowed: [-1000, 1000]");
}

}  // namespace
}  // namespace scanbed::scenarios
