// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/world/world.hpp"

namespace scanbed::sim {

/// A material by name: "default", "white_paper", "grey_cardboard", "black_cardboard", "raw_wood", "grey_pvc",
/// "steel", "glass", "bark", "dark_cloth", "light_cloth".
///
/// @throws InputError listing the names where there is none of that name.
/// @par Source  Reflectivities of cardboard, wood, PVC and paper as in the table of SICK's "LMS 200
///              Technical Description"; those of cloth and bark and all roughnesses are assumed.
Material material_named(std::string_view name);

/// All names that material_named knows, in its order.
std::vector<std::string> material_names();

}  // namespace scanbed::sim
