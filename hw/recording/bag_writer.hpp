// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "hw/recording/byte_sink.hpp"
#include "hw/recording/scan_writer.hpp"

namespace scanbed::hw {

/// Writes sensor_msgs/LaserScan on the topic /scan, or that of the scan's source, and odometry, where it is
/// known, as tf2_msgs/TFMessage on /tf just before. Chunks are packed by lz4 and written each second of the
/// scans' time. What LaserScan cannot hold: see ros_messages.hpp. Metadata, features and truth are left out.
/// Memory grows by the index: some 100 bytes a second.
/// @throws InputError where the file is a pipe: a bag's header is written last.
std::unique_ptr<ScanWriter> write_bag(std::unique_ptr<FileSink> sink);

}  // namespace scanbed::hw
