// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "hw/recording/byte_stream.hpp"
#include "hw/recording/recording_options.hpp"
#include "hw/recording/scan_reader.hpp"
#include "hw/recording/scan_writer.hpp"

namespace scanbed::hw {

/// Opens a recording of any format; its content tells which, and its name where the content does not.
/// @throws InputError where it is missing, unreadable, empty, holds no scan, or the options do not validate.
///         Stopped where it is interrupted before the first scan; afterwards that is the end of the
///         recording.
std::unique_ptr<ScanReader> open_recording(const std::filesystem::path& path, const RecordingOptions& options,
                                           DamageReport report);

/// The same of any bytes; `name` is what messages call them, and its ending counts as a file's would.
std::unique_ptr<ScanReader> open_recording(std::unique_ptr<ByteStream> bytes, const std::string& name,
                                           const RecordingOptions& options, DamageReport report);

/// Begins a recording in the format that the path's ending asks for (see format_of_name).
/// @throws InputError where the ending is of no format.
/// @throws WriteFault where the file cannot be made.
std::unique_ptr<ScanWriter> create_recording(const std::filesystem::path& path,
                                             const RecordingMetadata& metadata);

}  // namespace scanbed::hw
