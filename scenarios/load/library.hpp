// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace scanbed::scenarios {

/// The folder of the scenarios that come with the program: SCANBED_LIBRARY where it is set, else beside the
/// installed program (../share/scanbed/library), else in the source tree it was built from.
///
/// @throws InputError where none of them is a folder.
std::filesystem::path library_folder();

/// Names of its scenarios: file names without ".yaml", sorted.
std::vector<std::string> library_names(const std::filesystem::path& folder);

/// The library's scenarios that a pattern of the shell (with *, ? or [...]) fits; any other text itself.
///
/// @throws InputError where the pattern fits none.
std::vector<std::string> names_that_fit(const std::string& name_or_pattern);

/// The file of a scenario: itself where the text has a '/' or ends in .yaml or .yml, else that name of the
/// library.
///
/// @throws InputError with the nearest known name where the library has none of that name.
std::filesystem::path find_scenario(std::string_view name_or_path);

}  // namespace scanbed::scenarios
