// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "hw/recording/byte_stream.hpp"
#include "hw/recording/mcap_record.hpp"
#include "hw/recording/scan_source.hpp"

namespace scanbed::hw {

/// Which topic of an MCAP file is read.
struct McapOptions {
  std::string only;  ///< a topic, its leading slash or not; empty reads all that carry foxglove.LaserScan
};

/// Scans of an MCAP file: JSON messages of foxglove.LaserScan, in the order of the file, chunked (plain, lz4,
/// zstd) or not; with what our own channels say about them (see mcap_message.hpp). A chunk or message that is
/// damaged is reported and skipped. After the last scan, InputError where the file was not finished, is cut
/// off, or the checksum over all data does not fit.
///
/// @par Source  mcap.dev/spec, major version 0. Departs: the index is not used, since a file whose recorder
///              was killed has none.
std::unique_ptr<ScanSource> read_mcap(std::unique_ptr<ByteStream> bytes, std::string name,
                                      const McapOptions& options, DamageReport report);

}  // namespace scanbed::hw
