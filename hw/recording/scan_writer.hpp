// SPDX-License-Identifier: MIT
#pragma once

#include "core/detect/features.hpp"
#include "core/scan/laser_scan.hpp"
#include "core/scan/truth.hpp"

namespace scanbed::hw {

/// What is recorded of one scan.
struct ScanRecord {
  const LaserScan& scan;
  const Features* features = nullptr;  ///< nullptr where they are not known
  const Truth* truth = nullptr;        ///< nullptr where it is not known
};

/// Writes a recording, one scan at a time. What a format cannot hold it leaves out; each format's header says
/// what that is. A recording that was not finished (the program was killed) can be read up to its last
/// complete line or chunk.
class ScanWriter {
 public:
  ScanWriter() = default;
  ScanWriter(const ScanWriter&) = delete;
  ScanWriter& operator=(const ScanWriter&) = delete;
  virtual ~ScanWriter() = default;

  /// @throws InputError where the format cannot hold the scan at all (a time before its epoch).
  /// @throws WriteFault where the operating system fails to write.
  virtual void write(const ScanRecord& record) = 0;

  /// Writes what is held back, and the index where the format has one, and gives the file its name. Nothing
  /// may be written after it.
  /// @throws WriteFault where the operating system fails to write.
  virtual void finish() = 0;
};

}  // namespace scanbed::hw
