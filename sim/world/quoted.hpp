// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace scanbed::sim {

/// How errors call a thing of the world: "solid 'table'".
inline std::string quoted(const char* kind, const std::string& id) {
  return std::string(kind) + " '" + id + "'";
}

}  // namespace scanbed::sim
