// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "hw/recording/byte_sink.hpp"
#include "hw/recording/scan_reader.hpp"
#include "hw/recording/scan_writer.hpp"

namespace scanbed::hw {

/// Writes a CARMEN log: a scan with odometry as ROBOTLASERn, without as RAWLASERn, where n tells lasers
/// apart, or as the message that its source names where that can hold it (FLASER cannot say where its beams
/// point). Numbers have as many digits as they need, so that ranges, angles, odometry and times come back to
/// the bit; but no echo is 81.91 (the LMS's code) or the maximum range where that is greater, too close is 0,
/// and the nearest range limit and the beams' timing are left out, as are features and truth. Metadata is a
/// comment. write() throws InputError for a fifth laser, or a third with odometry.
std::unique_ptr<ScanWriter> write_carmen_log(std::unique_ptr<ByteSink> sink,
                                             const RecordingMetadata& metadata);

}  // namespace scanbed::hw
