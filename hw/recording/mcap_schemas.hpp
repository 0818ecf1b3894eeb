// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace scanbed::hw {

/// What the channels of our MCAP files carry.
enum class McapContent { kScan, kBeams, kFeatures, kTruth };

/// A schema and the ending of its topic, which follows that of the scan.
struct McapSchema {
  std::string_view name;
  std::string_view topic_ending;
  std::string_view text;  ///< JSON Schema
};

/// By McapContent. foxglove.LaserScan is what viewers know. The others are ours: Beams is what a LaserScan
/// cannot say. They keep to the kinds that viewers convert: no null, no array in an array.
extern const std::array<McapSchema, 4> kMcapSchemas;

}  // namespace scanbed::hw
