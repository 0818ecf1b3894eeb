// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scan/laser_scan.hpp"
#include "hw/recording/scan_source.hpp"
#include "hw/recording/scan_writer.hpp"

namespace scanbed::hw {

// The messages of our MCAP channels, as JSON. A LaserScan holds ranges that are numbers: a beam without range
// is 0 in it, and Beams says which of the three it was. Together they keep a scan to the bit.

std::string encode_mcap_scan(const LaserScan& scan);
std::string encode_mcap_beams(const LaserScan& scan);
std::string encode_mcap_features(const Features& features, double time_s);
std::string encode_mcap_truth(const Truth& truth, double time_s);

/// What came before a LaserScan about the same scan: JSON texts, empty where there was none.
struct McapSideMessages {
  std::string beams;
  std::string features;
  std::string truth;
};

/// A scan of a LaserScan and what came with it; all but its index. Without Beams: ranges that are 0,
/// negative, or beyond 1e30 are kNoEcho, source and odometry empty, and angles are evened out (see
/// even_angles.hpp).
/// @throws InputError where a text is no such message, or they do not fit each other.
void decode_mcap_scan(std::string_view scan_json, const McapSideMessages& side, RecordedScan& out);

}  // namespace scanbed::hw
