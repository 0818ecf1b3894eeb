// SPDX-License-Identifier: MIT
#include "scenarios/load/expression.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "scenarios/load/value.hpp"
#include "tests/scenarios/scenario_text.hpp"

namespace scanbed::scenarios {
namespace {

const Variables kVariables = {{"R", 0.25}, {"gap", 1.2}, {"a", 5.0}, {"a-b", 7.0}};

double value_of(std::string_view text) {
  const Evaluated result = evaluate(text, kVariables);
  EXPECT_EQ(result.fault, "") << text;
  return result.value;
}

std::string fault_of(std::string_view text) {
  return evaluate(text, kVariables).fault;
}

TEST(ExpressionTest, EvaluatesArithmeticWithTheUsualPrecedence) {
  EXPECT_EQ(value_of("1 + 2 * 3"), 7.0);
  EXPECT_EQ(value_of("(1 + 2) * 3"), 9.0);
  EXPECT_EQ(value_of("7 - 2 - 1"), 4.0);
  EXPECT_EQ(value_of("8 / 2 / 2"), 2.0);
  EXPECT_EQ(value_of("-2 * -3"), 6.0);
  EXPECT_EQ(value_of("2--3"), 5.0);
  EXPECT_EQ(value_of("1e-3*2"), 0.002);
  EXPECT_EQ(value_of("$R * 2 + 0.1"), 0.6);
  EXPECT_EQ(value_of("-($gap - $R)"), -(1.2 - 0.25));
}

TEST(ExpressionTest, KnowsAFewFunctionsAnglesInDegrees) {
  EXPECT_EQ(value_of("sqrt(16)"), 4.0);
  EXPECT_EQ(value_of("min($R, 2)"), 0.25);
  EXPECT_EQ(value_of("max(1, 2) + abs(-1)"), 3.0);
  EXPECT_NEAR(value_of("sin(30)"), 0.5, 1e-15);
  EXPECT_NEAR(value_of("cos(60)"), 0.5, 1e-15);
  EXPECT_NEAR(value_of("tan(45)"), 1.0, 1e-15);
  EXPECT_EQ(value_of("round(2.6)"), 3.0);
  EXPECT_EQ(value_of("2 * pi"), 2.0 * M_PI);
}

TEST(ExpressionTest, TakesTheLongestVariableThatThereIs) {
  EXPECT_EQ(value_of("$a-b"), 7.0);
  EXPECT_EQ(value_of("$a - 1"), 4.0);
  EXPECT_EQ(value_of("$a-1"), 4.0);
}

TEST(ExpressionTest, SaysWhatIsWrong) {
  EXPECT_EQ(fault_of("$r + 1"), "unknown variable 'r'; did you mean 'R'?");
  EXPECT_EQ(fault_of("sqr(2)"), "unknown function 'sqr'; did you mean 'sqrt'?");
  EXPECT_EQ(fault_of("1 +"), "ends where a number should be");
  EXPECT_EQ(fault_of("1 2"), "unexpected '2'");
  EXPECT_EQ(fault_of("(1"), "a ')' is missing");
  EXPECT_EQ(fault_of("sqrt(1"), "a ')' is missing after sqrt");
  EXPECT_EQ(fault_of("sqrt 1"), "'(' must follow sqrt");
  EXPECT_EQ(fault_of("min(1)"), "min takes two numbers");
  EXPECT_EQ(fault_of("1 / ($R - 0.25)"), "divides by zero");
  EXPECT_EQ(fault_of("1e308 * 10"), "is no finite number");
  EXPECT_EQ(fault_of("sqrt(-1)"), "is no finite number");
  EXPECT_EQ(fault_of("2 * 012"), "expected a number, found '012'");
  EXPECT_EQ(fault_of("2 * *"), "expected a number at '*'");
}

TEST(ExpressionTest, EndsForAnyDepth) {
  EXPECT_EQ(value_of(std::string(32, '(') + "1" + std::string(32, ')')), 1.0);
  EXPECT_EQ(fault_of(std::string(100'000, '(') + "1"), "nests too deeply; allowed: 32");
  EXPECT_EQ(value_of(std::string(100'000, '-') + "1"), 1.0);
  std::string calls;
  for (int i = 0; i < 1000; ++i) calls += "abs(";
  EXPECT_EQ(fault_of(calls), "nests too deeply; allowed: 32");
}

TEST(ExpressionTest, LeavesWordsToBeWords) {
  EXPECT_FALSE(looks_like_arithmetic("walker"));
  EXPECT_FALSE(looks_like_arithmetic("rs422-500k"));
  EXPECT_FALSE(looks_like_arithmetic("12"));
  EXPECT_TRUE(looks_like_arithmetic("pi"));
  EXPECT_TRUE(looks_like_arithmetic("cos(3)"));
  EXPECT_TRUE(looks_like_arithmetic("2 * 3"));
  EXPECT_TRUE(looks_like_arithmetic("-$R"));
}

RC_GTEST_PROP(ExpressionTest, AgreesWithTheCompilersArithmetic, (int a, int b, int c)) {
  const double x = a;
  const double y = b;
  const double z = c;
  const Variables variables = {{"x", x}, {"y", y}, {"z", z}};
  const auto of = [&](std::string_view text) { return evaluate(text, variables).value; };
  RC_ASSERT(of("$x + $y * $z") == x + y * z);
  RC_ASSERT(of("($x - $y) * -$z") == (x - y) * -z);
  RC_ASSERT(of("$x/2-$y/4+$z") == x / 2 - y / 4 + z);
}

// What the language is for: in values, in lists, in variables, from the command line.
TEST(ExpressionTest, StandsWhereverANumberStands) {
  const std::string text = testing::kHead +
                           "vars: {R: 0.25, d: $R * 2}\n"
                           "world:\n"
                           "  - {id: c, cylinder: {at: [$d + 3, -$R * 4], r: \"max($R, 0.1)\"}}\n";
  const auto column = [&](const std::vector<Setting>& settings) {
    return std::get<sim::Cylinder>(parse_scenario(text, "f", settings).world.solids.at(0).shape);
  };
  EXPECT_EQ(column({}).center_m, Eigen::Vector2d(3.5, -1.0));
  EXPECT_EQ(column({}).radius_m, 0.25);
  EXPECT_EQ(column({{"vars.R", "0.5"}}).center_m, Eigen::Vector2d(4.0, -2.0));
  EXPECT_EQ(column({{"world.c.cylinder.r", "$d / 5"}}).radius_m, 0.1);
}

TEST(ExpressionTest, FaultsNameTheirPlace) {
  EXPECT_EQ(testing::parse_error("vars: {R: 1}\nworld:\n  - {id: c, cylinder: {at: [$R * , 1], r: 1}}\n"),
            "f:6:29: at: '$R *': ends where a number should be");
  EXPECT_EQ(testing::parse_error("vars: {R: 1, d: $Q * 2}\n"),
            "f:4:17: d: unknown variable 'Q'; did you mean 'R'?");
}

}  // namespace
}  // namespace scanbed::scenarios
