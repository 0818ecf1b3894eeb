// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "core/scan/laser_scan.hpp"
#include "scenarios/run/laser_spec.hpp"

namespace scanbed::scenarios {

/// Tells once on standard error that a recording mixes lasers: their scans follow each other as if they were
/// of one.
class SourceWatch {
 public:
  explicit SourceWatch(const LaserSpec& spec);

  void see(const LaserScan& scan);

 private:
  std::string name_;
  bool is_watching_;
  std::optional<std::string> first_;
};

}  // namespace scanbed::scenarios
