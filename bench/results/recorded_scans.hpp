// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>

#include "core/scan/laser_scan.hpp"

namespace scanbed::bench {

/// Hands out the scans of a CARMEN log, one after the other; what its reader warns of goes to standard error.
/// @returns their number.
int for_each_scan(const std::filesystem::path& log, const std::function<void(const LaserScan&)>& use);

}  // namespace scanbed::bench
