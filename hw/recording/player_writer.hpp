// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "hw/recording/byte_sink.hpp"
#include "hw/recording/scan_reader.hpp"
#include "hw/recording/scan_writer.hpp"

namespace scanbed::hw {

/// Writes a text log as Player's writelog does and its readlog reads: a scan as laser 1:1, with odometry as
/// 1:2. The format rounds: ranges and odometry to millimetres (milliradians), times to milliseconds, the
/// first angle to 1e-4 rad and steps to 1e-8 rad (which read_player_log undoes for evenly divided angles). No
/// echo is max_range; too close and invalid are both 0, since readlog's clients abort on anything else.
/// Sources become laser indices, with their names in comments, as is metadata. Features, truth and timing are
/// left out. Player's own reader takes lines of up to 2041 beams.
std::unique_ptr<ScanWriter> write_player_log(std::unique_ptr<ByteSink> sink,
                                             const RecordingMetadata& metadata);

}  // namespace scanbed::hw
