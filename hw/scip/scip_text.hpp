// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scanbed::hw {

/// The character that closes a line of SCIP 2.0: six bits of the sum of its bytes.
/// @par Source  Hokuyo, "Communication Protocol Specification for SCIP2.0 Standard", C-42-03320B.
char scip_sum(std::string_view body);

/// The line without its sum; empty where the sum is another, or there is none.
std::optional<std::string_view> strip_sum(std::string_view line);

/// A number of 2, 3 or 4 characters of six bits each, most significant first; empty where a character is none
/// of them.
std::optional<std::int64_t> decode_scip(std::string_view text);
std::string encode_scip(std::int64_t value, int num_chars);

/// Data lines of at most 64 characters with their sums, each line with its line feed.
std::string to_scip_blocks(std::string_view data);

/// The data of such lines, joined; empty where a sum is wrong.
std::optional<std::string> join_scip_blocks(const std::vector<std::string>& lines);

/// Cuts a stream of bytes into messages: lines up to an empty one. A message longer than any sensor's is
/// dropped.
class ScipReader {
 public:
  void feed(std::string_view bytes);
  /// The next whole message without its empty line; false where none is complete.
  bool next(std::vector<std::string>& lines);
  void clear();

 private:
  std::string buffer_;
  std::vector<std::string> lines_;
  std::size_t size_ = 0;  // of lines_
};

}  // namespace scanbed::hw
