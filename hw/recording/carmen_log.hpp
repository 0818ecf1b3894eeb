// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "hw/recording/byte_stream.hpp"
#include "hw/recording/carmen_message.hpp"
#include "hw/recording/scan_reader.hpp"

namespace scanbed::hw {

using CarmenLogCounts = RecordingCounts;

/// Scans of a CARMEN log, plain or gzip, streaming: FLASER, RLASER, RAWLASER1..4, ROBOTLASER1..2. Which of
/// the two it is the first bytes say, not the name. Memory does not grow with the file. What the messages
/// mean: parse_carmen_line.
class CarmenLog final : public ScanReader {
 public:
  using Report = DamageReport;

  /// Reads on to the first scan, so that geometry() is known.
  /// @param report  may be empty.
  /// @throws InputError where the file is missing, unreadable, empty or holds no scan, or the options do not
  ///         validate.
  CarmenLog(const std::filesystem::path& path, const CarmenLogOptions& options, Report report);

  /// Reads any bytes; `name` is what messages call them.
  /// @throws InputError where they hold no scan or the options do not validate.
  CarmenLog(std::unique_ptr<ByteStream> bytes, std::string name, const CarmenLogOptions& options,
            Report report);
  ~CarmenLog() override;

  /// Of the scan that next() gave last; of the first one before that.
  const ScanGeometry& geometry() const override;

  /// Waits for bytes that are still to come, whatever `timeout`; what interrupts that ends the log. A scan
  /// without time has the time of the scan before it, or 0.
  /// @throws InputError where compressed data is cut off or damaged, after all scans on complete lines before
  ///         that were given.
  /// @throws SensorFault where the operating system fails to read the file.
  bool next(LaserScan& scan, Seconds timeout) override;

  const CarmenLogCounts& counts() const override;
  const RecordingMetadata& metadata() const override;  ///< empty

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scanbed::hw
