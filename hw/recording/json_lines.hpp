// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "hw/recording/byte_sink.hpp"
#include "hw/recording/byte_stream.hpp"
#include "hw/recording/scan_source.hpp"
#include "hw/recording/scan_writer.hpp"

namespace scanbed::hw {

// Our own recordings: JSON Lines that keep everything, bit by bit.
//
//   {"format":"scanbed.recording","version":1,"metadata":{"seed":"7", ...}}
//   {"scan":0,"t_s":0.0,"source":"","geometry":{...},"odometry":[x,y,theta],"ranges":[1.25,"inf","-inf","nan",
//   ...],
//    "features":[...],"truth":{...}}
//   ...
//   {"end":1}
//
// odometry, features and truth are left out where they are not known, health where all is fine; their parts
// are those of scan_json.hpp. A range is a number, or "inf" (no echo), "-inf" (too close) or "nan" (invalid).

/// What the first line says its "format" is. It may be spaced and ordered in any way that JSON allows.
inline constexpr std::string_view kJsonLinesFormat = "scanbed.recording";

std::unique_ptr<ScanWriter> write_json_lines(std::unique_ptr<ByteSink> sink,
                                             const RecordingMetadata& metadata);

/// Which scans of a recording are read.
struct JsonLinesOptions {
  std::string only;  ///< those of this source; empty reads all
};

/// Reads plain or gzip. A line that is no scan is reported with its number and skipped, and so is, once, all
/// that stands behind the end line. After the last scan, InputError if compressed data is cut off or damaged,
/// or if the end line is missing: the recorder was killed, or the file was cut off.
/// @throws InputError where the first line is not that of a recording, or of a later version.
std::unique_ptr<ScanSource> read_json_lines(std::unique_ptr<ByteStream> bytes, std::string name,
                                            const JsonLinesOptions& options, DamageReport report);

}  // namespace scanbed::hw
