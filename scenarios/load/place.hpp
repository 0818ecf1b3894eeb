// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace scanbed::scenarios {

/// What values were written in.
struct Source {
  std::string name;                   ///< of the file, or "--set sensor.height=0.3"
  std::filesystem::path folder = {};  ///< of the file, never empty; empty where it is none
};

/// Where a value was written: a place in a file, or a flag of the command line (line 0).
struct Place {
  std::shared_ptr<const Source> source;  ///< may be null
  int line = 0;                          ///< from 1; 0 where the source has no lines
  int column = 0;                        ///< from 1, in characters
};

/// "file:line:column", or the source alone where it has no lines.
std::string to_string(const Place& place);

/// @throws InputError "file:line:column: message", always; with control characters as '?', so one line.
[[noreturn]] void refuse(const Place& place, std::string_view message);

/// Text from outside, fit for a one-line message: in quotes, shortened to 40 characters, control characters
/// as '?'.
std::string quote(std::string_view text);

}  // namespace scanbed::scenarios
