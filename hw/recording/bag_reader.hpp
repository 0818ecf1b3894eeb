// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "hw/recording/byte_stream.hpp"
#include "hw/recording/scan_source.hpp"

namespace scanbed::hw {

/// ROS bags of version 2.0 begin with this.
inline constexpr std::string_view kBagMagic = "#ROSBAG V2.0\n";

/// Which topic of a bag is read.
struct BagOptions {
  std::string only;  ///< a topic, its leading slash or not; empty reads all that carry sensor_msgs/LaserScan
};

/// Scans of a ROS 1 bag, in the order of the file. Chunks may be packed by bz2 or lz4. The topic becomes the
/// scan's source, without its slash; "scan" becomes none. Odometry is that of the last transform from "odom"
/// to "base_link" before the scan. A chunk or message that is damaged is reported and skipped; of a last
/// chunk that is torn or was not finished its whole messages are read, if it is not packed. After the last
/// scan, InputError where the bag was not finished or is cut off.
///
/// @par Source  wiki.ros.org/Bags/Format/2.0. Departs: the index is not used, since a bag whose recorder was
///              killed has none.
std::unique_ptr<ScanSource> read_bag(std::unique_ptr<ByteStream> bytes, std::string name,
                                     const BagOptions& options, DamageReport report);

}  // namespace scanbed::hw
