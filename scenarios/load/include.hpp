// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "scenarios/load/node.hpp"
#include "scenarios/load/value.hpp"

namespace scanbed::scenarios {

/// What the includes of one scenario may cost, all together.
struct IncludeLimits {
  int max_files = 32;
  int max_depth = 8;
  std::size_t max_nodes = 60'000;  ///< values
};

/// The names of files that `include:` has: one, or a list of them.
std::vector<std::pair<Place, std::string>> include_names(const Value& value);

/// Replaces the key `include` of a scenario's tree (a file name, or a list of them) by what the files say:
/// each lies over those before it, and the scenario's own values lie over them all (lay_over). Files are
/// found as find_confined says, may include others, and are read once for each time they are named.
///
/// @param folder  of the file that the tree was read from; empty where it is none.
/// @throws InputError at the place of the include that is not found, names a file that includes itself, or
///                    goes beyond the limits; and what read_yaml says of the files.
void resolve_includes(TreeNode& root, const std::filesystem::path& folder, const IncludeLimits& limits = {});

}  // namespace scanbed::scenarios
