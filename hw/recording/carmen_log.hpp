// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/scan/range_sensor.hpp"

namespace scanbed::hw {

/// How a CARMEN log is read.
struct CarmenLogOptions {
  std::string only;  ///< read this message alone ("FLASER", "RAWLASER2", ...); empty reads all laser messages
  /// Readings from here on mean "no return". The LMS's overflow codes start at 8183 steps: 81.83 m in
  /// centimetres.
  double no_return_m = 81.83;
};

/// What a log held, counted as it is read.
struct CarmenLogCounts {
  std::int64_t num_scans = 0;
  std::int64_t num_damaged_lines = 0;
  std::int64_t num_other_lines = 0;  ///< comments, parameters, odometry and other messages that carry no scan
};

/// Scans of a CARMEN log, plain or gzip, streaming: FLASER, RLASER, RAWLASER1..4, ROBOTLASER1..2.
class CarmenLog final : public RangeSensor {
 public:
  /// Called for each damaged line, which is then skipped: a message with file and line number.
  using Report = std::function<void(const std::string&)>;

  /// @throws InputError where the file is missing, unreadable or empty, or the options do not validate.
  CarmenLog(const std::filesystem::path& path, const CarmenLogOptions& options, Report report);
  ~CarmenLog() override;

  const ScanGeometry& geometry() const override;

  /// @throws InputError when the end is reached and the file held no scan, or where compressed data is cut
  /// off or
  ///         damaged (after all complete lines before it were given).
  bool next(LaserScan& scan, Seconds timeout) override;

  const CarmenLogCounts& counts() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scanbed::hw
