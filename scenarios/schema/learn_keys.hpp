// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "scenarios/load/asked.hpp"

namespace scanbed::scenarios {

/// Reads a tree, notes what it asks, and throws InputError where it refuses.
using Reader = std::function<void(const TreeNode& root, AskedRecorder& recorder)>;

/// Learns all that a reader may ask, from its questions alone: it is given small trees again and again, each
/// with one or two keys more than the reader insists on, until no tree leads to a new question.
///
/// So no second list of keys exists that could differ from what is read. What is found is what some tree of
/// that kind leads to; a key that is only asked for where three others have certain values is not.
///
/// @par Cost  O(trees) reads: for each map the square of its number of keys.
Asked learn_keys(const Reader& read);

}  // namespace scanbed::scenarios
