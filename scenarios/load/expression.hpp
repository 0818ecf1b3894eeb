// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace scanbed::scenarios {

/// Names that numbers of a file may refer to as "$name".
using Variables = std::map<std::string, double>;

/// What arithmetic in a scenario file comes to, or why it comes to nothing.
struct Evaluated {
  double value = 0.0;
  std::string fault;        ///< empty where there is a value
  bool is_unknown = false;  ///< the fault is a name that is not known
};

/// Whether a text that is no plain number may be arithmetic: it names a variable, begins with a parenthesis,
/// a sign or a digit, or with a function or constant. Anything else is just a word.
bool looks_like_arithmetic(std::string_view text);

/// Evaluates + - * / with parentheses, a unary sign, $variables, pi, and the functions abs, cos, max, min,
/// round, sin, sqrt and tan (angles in degrees, as everywhere in scenario files). "$R * 2 + 0.1".
///
/// A variable's name ends at the first character that is no letter, digit or _; a name with '-' is taken
/// where no shorter one is known, so "$a-b" is the variable a-b if there is one.
///
/// @returns a finite value or a fault; nests at most 32 deep.
/// @par Cost  O(length), with one look-up a name.
Evaluated evaluate(std::string_view text, const Variables& variables);

}  // namespace scanbed::scenarios
