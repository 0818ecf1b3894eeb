// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "scenarios/load/node.hpp"

namespace scanbed::scenarios {

/// What a YAML file may cost.
struct YamlLimits {
  std::size_t max_bytes = std::size_t{256} * 1024;
  int max_depth = 24;             ///< of nested lists and maps
  std::size_t max_nodes = 20000;  ///< all values, after aliases are expanded
};

/// Parses one YAML document. An empty document is a node of kind kNothing.
///
/// @param source  what places call the text: its file name.
/// @throws InputError "file:line:column: ..." for bad syntax, duplicate keys, keys that are not plain text,
///                    tags, aliases within their own anchor, a second document, and texts beyond the limits.
TreeNode parse_yaml(std::string_view text, const std::string& source, const YamlLimits& limits = {});

/// The same for a file. @throws InputError also where it is missing, no regular file, unreadable or too
/// large.
TreeNode read_yaml(const std::filesystem::path& path, const YamlLimits& limits = {});

}  // namespace scanbed::scenarios
