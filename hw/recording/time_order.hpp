// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "hw/recording/scan_source.hpp"

namespace scanbed::hw {

/// The scans of a source in the order of their times, those of one time in the order of the source: chunks of
/// bags and MCAP files may overlap or stand in any order, and so may messages within them.
///
/// Holds 4096 scans, which is more than a chunk's; but where scans have to be waited for, as in a pipe from a
/// recorder that runs, none for more than 0.1 s. A scan that stands farther behind a later one is given when
/// it comes, and the first of them is reported. What the source throws comes after the last scan.
/// @param name  of the recording, for the report.
std::unique_ptr<ScanSource> in_time_order(std::unique_ptr<ScanSource> source, std::string name,
                                          DamageReport report);

}  // namespace scanbed::hw
