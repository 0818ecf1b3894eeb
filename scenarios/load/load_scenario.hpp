// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "scenarios/load/asked.hpp"
#include "scenarios/load/scenario.hpp"
#include "scenarios/load/set_path.hpp"

namespace scanbed::scenarios {

/// Reads a scenario file. Lengths in metres, times in seconds, angles in degrees where the key ends in _deg
/// or the value is a pose [x, y, degrees]; "$R" stands for the number `R` of `vars`. Other files may be
/// included (resolve_includes).
///
/// @param settings  change values of the file before it is checked, in this order.
/// @throws InputError "file:line:column: ..." for the first thing that does not fit: syntax, unknown or
///                    duplicate keys (with the nearest known key), wrong types, numbers out of range, a world
///                    that cannot be.
Scenario load_scenario(const std::filesystem::path& path, std::span<const Setting> settings = {});

/// The same from text; `source` stands for the file's name in messages. Includes from the library only.
Scenario parse_scenario(std::string_view text, const std::string& source,
                        std::span<const Setting> settings = {});

/// Reads a tree without includes, and notes all that is asked of it. @throws InputError as load_scenario does
/// for single values; whether they fit together is not checked.
void read_scenario(const TreeNode& root, AskedRecorder& recorder);

}  // namespace scanbed::scenarios
