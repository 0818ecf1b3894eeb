// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "hw/recording/byte_sink.hpp"
#include "hw/recording/scan_reader.hpp"
#include "hw/recording/scan_writer.hpp"

namespace scanbed::hw {

/// Writes an MCAP file that keeps everything to the bit: JSON messages of foxglove.LaserScan on the topic
/// /scan, or that of the scan's source, and beside it /scan/beams, /scan/features and /scan/truth (see
/// mcap_message.hpp); metadata as the record "scanbed". Chunks are packed by lz4, indexed, and written each
/// second of the scans' time or each MiB. Memory grows by the index: some 150 bytes a chunk.
std::unique_ptr<ScanWriter> write_mcap(std::unique_ptr<ByteSink> sink, const RecordingMetadata& metadata);

}  // namespace scanbed::hw
