// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "scenarios/load/node.hpp"

namespace scanbed::scenarios {

/// "sensor.noise.sigma=0.01" in two.
struct Setting {
  std::string path;
  std::string value;
};

/// @throws InputError where there is no '=', or nothing before it.
Setting parse_setting(std::string_view text);

/// Replaces or adds one value of a tree: what `--set PATH=VALUE` does before the tree is read, so that the
/// value is checked as if it stood in the file. Steps of the path are keys; in lists they are the id of an
/// element or its index from 0. Maps that are missing on the way are made. VALUE is YAML.
///
/// @throws InputError where a step meets a single value, or a list that has no such element.
void set_path(TreeNode& root, const Setting& setting);

}  // namespace scanbed::scenarios
