// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>

#include "core/scan/truth.hpp"

namespace scanbed::scenarios {

/// What tells one scan from another by its ranges, whichever way it came.
std::uint64_t range_hash(std::span<const double> range_m);

/// Writes truth beside the wire, a line a scan: {"scan":0,"hash":"9ae16a3b2f90404f","truth":{...}}, the hash
/// that of its ranges and the truth as in recordings (hw/recording/scan_json.hpp). Each line is out before
/// the scan that it belongs to. What a file held before stays until begin(); one that is new and never begun
/// is removed again.
class TruthWriter {
 public:
  /// @throws OutputFault where the file cannot be made.
  explicit TruthWriter(const std::filesystem::path& path);
  ~TruthWriter();

  TruthWriter(const TruthWriter&) = delete;
  TruthWriter& operator=(const TruthWriter&) = delete;

  /// Empties the file.
  void begin();

  /// @pre begin() was called. @throws OutputFault where the line cannot be written.
  void write(std::int64_t scan, std::span<const double> range_m, const Truth& truth);

 private:
  void check() const;

  std::filesystem::path path_;
  bool is_new_ = false;
  bool has_begun_ = false;
  std::ofstream file_;
};

/// Finds the truth of scans in a file that may still be growing. Scans come in the order of the file; some
/// may be missing, since a wire loses scans.
class TruthReader {
 public:
  /// @throws InputError where the file cannot be read.
  explicit TruthReader(const std::filesystem::path& path);

  /// Truth of the scan; nullptr where no further line has it. Lines before it are then not looked at again.
  /// @throws InputError for a line that is no truth, or that of fewer or more beams.
  const Truth* find(std::span<const double> range_m);

 private:
  /// One that is written to its end.
  std::optional<std::string> next_line();
  /// Takes the truth from the line of the scan that has so many beams, and tells whether it is that.
  bool take(const std::string& line, std::uint64_t hash, int num_beams);

  std::filesystem::path path_;
  std::ifstream file_;
  std::string partial_;  // a line whose end is not written yet
  std::optional<std::uint64_t> hash_;
  Truth truth_;  // of the scan with that hash
};

}  // namespace scanbed::scenarios
