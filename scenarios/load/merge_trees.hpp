// SPDX-License-Identifier: MIT
#pragma once

#include "scenarios/load/node.hpp"

namespace scanbed::scenarios {

/// Lays one scenario's tree over another's, whose values it changes or adds to: maps key by key, and so on
/// within them. Lists whose elements have ids (world, actors) element by element: one with the id of another
/// is laid over it, all else is appended. A key without a value takes away that of the base. Everything else
/// is replaced.
///
/// @par Cost  O(nodes of both), and O(n m) for lists of n and m elements.
void lay_over(TreeNode& base, TreeNode over);

}  // namespace scanbed::scenarios
