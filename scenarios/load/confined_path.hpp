// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "scenarios/load/place.hpp"

namespace scanbed::scenarios {

/// Finds a file that a scenario names: in the folder of the file that names it, else in the library. A file
/// from elsewhere may thus say what it likes without reading anything but its neighbours.
///
/// @param name    as written at `place`: relative, without "..".
/// @param folder  of the naming file; empty where it is no file, so that only the library counts.
/// @returns its canonical path, a regular file.
/// @throws InputError at `place` where there is none, or where links lead out of both folders.
std::filesystem::path find_confined(const Place& place, const std::string& name,
                                    const std::filesystem::path& folder);

}  // namespace scanbed::scenarios
