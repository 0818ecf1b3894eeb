// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace scanbed::hw {

/// Reads the fields of a line, which blanks or tabs separate. The first failure sticks: what is read after it
/// is meaningless, so a caller asks once, at the end, whether all went well.
class FieldReader {
 public:
  /// The text must outlive the reader.
  explicit FieldReader(std::string_view text) : rest_(text) {}

  /// The next field, empty at the end of the line (which is no failure).
  std::string_view word();

  /// The next field as a number; "nan" and "inf" are numbers. NaN after a failure.
  /// @param name of the field, for the message.
  double number(std::string_view name);

  /// As number(), but NaN and infinity are failures.
  double finite(std::string_view name);

  /// As finite(), but what is_time() refuses is a failure too.
  double time(std::string_view name);

  /// The next field as a whole number in [0, 2^31). 0 after a failure.
  int count(std::string_view name);

  /// The next field as count() would read it, or nothing; the reader does not move and does not fail.
  std::optional<int> peek_count() const;

  /// How many fields are left.
  int num_left() const;

  void fail(std::string what);
  bool ok() const { return failure_.empty(); }

  /// Why it failed: "accuracy is 'abc', not a number"; empty while all is well.
  const std::string& failure() const { return failure_; }

 private:
  std::string_view rest_;
  std::string failure_;
};

}  // namespace scanbed::hw
