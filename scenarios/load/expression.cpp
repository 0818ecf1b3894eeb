// SPDX-License-Identifier: MIT
#include "scenarios/load/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/geometry/angles.hpp"
#include "scenarios/load/is_digit.hpp"
#include "scenarios/load/nearest_name.hpp"
#include "scenarios/load/number.hpp"
#include "scenarios/load/place.hpp"

namespace scanbed::scenarios {
namespace {

constexpr int kMostDepth = 32;

struct Function {
  std::string_view name;
  std::size_t num_arguments;
  double (*of)(double, double);
};

constexpr std::array<Function, 8> kFunctions = {{
    {"abs", 1, [](double x, double) { return std::abs(x); }},
    {"cos", 1, [](double x, double) { return std::cos(radians(x)); }},
    {"max", 2, [](double x, double y) { return std::max(x, y); }},
    {"min", 2, [](double x, double y) { return std::min(x, y); }},
    {"round", 1, [](double x, double) { return std::round(x); }},
    {"sin", 1, [](double x, double) { return std::sin(radians(x)); }},
    {"sqrt", 1, [](double x, double) { return std::sqrt(x); }},
    {"tan", 1, [](double x, double) { return std::tan(radians(x)); }},
}};
constexpr std::string_view kPiName = "pi";

const Function* find_function(std::string_view name) {
  for (const Function& function : kFunctions) {
    if (function.name == name) return &function;
  }
  return nullptr;
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

std::size_t length_of_name(std::string_view text, bool with_dashes) {
  std::size_t length = 0;
  while (length < text.size() &&
         (is_letter(text[length]) || is_digit(text[length]) || (with_dashes && text[length] == '-'))) {
    ++length;
  }
  return length;
}

// Digits, a fraction, an exponent; whether they are a number is for parse_number to say.
std::size_t length_of_number(std::string_view text) {
  std::size_t length = 0;
  while (length < text.size()) {
    const char c = text[length];
    const bool is_exponent_sign =
        (c == '+' || c == '-') && length > 0 && (text[length - 1] == 'e' || text[length - 1] == 'E');
    if (!is_digit(c) && !is_letter(c) && c != '.' && !is_exponent_sign) break;
    ++length;
  }
  return length;
}

std::vector<std::string> known_words() {
  std::vector<std::string> words{std::string(kPiName)};
  for (const Function& function : kFunctions) words.emplace_back(function.name);
  return words;
}

// Recursive descent. The first fault wins; after it, everything is 0 and the text is at its end.
class Evaluator {
 public:
  Evaluator(std::string_view text, const Variables& variables) : rest_(text), variables_(variables) {}

  Evaluated whole() {
    const double value = sum();
    skip_spaces();
    if (!rest_.empty()) fail("unexpected " + quote(rest_));
    if (fault_.empty() && !std::isfinite(value)) fail("is no finite number");
    return {fault_.empty() ? value : 0.0, fault_, is_unknown_};
  }

 private:
  double fail(std::string fault) {
    if (fault_.empty()) fault_ = std::move(fault);
    rest_ = {};
    return 0.0;
  }

  double fail_unknown(std::string fault) {
    is_unknown_ = fault_.empty();
    return fail(std::move(fault));
  }

  void skip_spaces() {
    while (!rest_.empty() && (rest_[0] == ' ' || rest_[0] == '\t')) rest_.remove_prefix(1);
  }

  bool accept(char c) {
    skip_spaces();
    if (rest_.empty() || rest_[0] != c) return false;
    rest_.remove_prefix(1);
    return true;
  }

  double sum() {
    double value = product();
    while (fault_.empty()) {
      if (accept('+')) {
        value += product();
      } else if (accept('-')) {
        value -= product();
      } else {
        break;
      }
    }
    return value;
  }

  double product() {
    double value = signed_operand();
    while (fault_.empty()) {
      if (accept('*')) {
        value *= signed_operand();
      } else if (accept('/')) {
        const double divisor = signed_operand();
        if (fault_.empty() && divisor == 0.0) return fail("divides by zero");
        value /= divisor;
      } else {
        break;
      }
    }
    return value;
  }

  double signed_operand() {
    double sign = 1.0;
    while (true) {
      if (accept('-')) {
        sign = -sign;
      } else if (!accept('+')) {
        return sign * operand();
      }
    }
  }

  double operand() {
    if (accept('(')) return parenthesis();
    if (accept('$')) return variable();
    if (rest_.empty()) return fail("ends where a number should be");
    if (is_letter(rest_[0])) return word();
    const std::string_view number = take(length_of_number(rest_));
    if (number.empty()) return fail("expected a number at " + quote(rest_));
    const std::optional<double> value = parse_number(number);
    return value ? *value : fail("expected a number, found " + quote(number));
  }

  double parenthesis() {
    if (++depth_ > kMostDepth) return fail(fmt::format("nests too deeply; allowed: {}", kMostDepth));
    const double value = sum();
    --depth_;
    if (fault_.empty() && !accept(')')) return fail("a ')' is missing");
    return value;
  }

  double variable() {
    const std::string_view whole = rest_.substr(0, length_of_name(rest_, true));
    std::string_view name = whole;
    if (!variables_.contains(std::string(whole))) name = rest_.substr(0, length_of_name(rest_, false));
    const auto found = variables_.find(std::string(name));
    if (found == variables_.end()) {
      std::vector<std::string> known;
      for (const auto& [known_name, value] : variables_) known.push_back(known_name);
      return fail_unknown(
          fmt::format("unknown variable {}{}", quote(name), name_hint(name, known, "variables")));
    }
    rest_.remove_prefix(name.size());
    return found->second;
  }

  double word() {
    const std::string_view name = take(length_of_name(rest_, false));
    if (name == kPiName) return kPi;
    const Function* function = find_function(name);
    if (function == nullptr) {
      return fail_unknown(
          fmt::format("unknown function {}{}", quote(name), name_hint(name, known_words(), "functions")));
    }
    if (!accept('(')) return fail(fmt::format("'(' must follow {}", name));
    if (++depth_ > kMostDepth) return fail(fmt::format("nests too deeply; allowed: {}", kMostDepth));
    std::array<double, 2> arguments{};
    for (std::size_t i = 0; i < function->num_arguments; ++i) {
      if (i > 0 && !accept(',')) return fail(fmt::format("{} takes two numbers", name));
      arguments[i] = sum();
    }
    --depth_;
    if (fault_.empty() && !accept(')')) return fail(fmt::format("a ')' is missing after {}", name));
    return function->of(arguments[0], arguments[1]);
  }

  std::string_view take(std::size_t length) {
    const std::string_view taken = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return taken;
  }

  std::string_view rest_;
  const Variables& variables_;
  std::string fault_;
  bool is_unknown_ = false;
  int depth_ = 0;
};

}  // namespace

bool looks_like_arithmetic(std::string_view text) {
  if (text.find('$') != std::string_view::npos) return true;
  if (text.find_first_of("+-*/(") == std::string_view::npos) return text == kPiName;
  const std::string_view name = text.substr(0, length_of_name(text, false));
  const bool begins_with_name = !text.empty() && is_letter(text[0]);
  return !begins_with_name || name == kPiName || find_function(name) != nullptr;
}

Evaluated evaluate(std::string_view text, const Variables& variables) {
  return Evaluator(text, variables).whole();
}

}  // namespace scanbed::scenarios
