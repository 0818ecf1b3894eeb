// SPDX-License-Identifier: MIT
#include "scenarios/command/source_watch.hpp"

#include <fmt/format.h>

#include "scenarios/command/log.hpp"
#include "scenarios/load/place.hpp"

namespace scanbed::scenarios {

SourceWatch::SourceWatch(const LaserSpec& spec)
    : name_(spec.target), is_watching_(spec.kind == LaserKind::kLog && spec.log.only.empty()) {}

void SourceWatch::see(const LaserScan& scan) {
  if (!is_watching_) return;
  if (!first_) first_ = scan.source;
  if (scan.source == *first_) return;
  is_watching_ = false;
  const std::string& example = first_->empty() ? scan.source : *first_;
  log_warning(fmt::format("{}: mixes scans of several lasers, {} and {}; read one with log:{}?only={}", name_,
                          quote(*first_), quote(scan.source), name_, example));
}

}  // namespace scanbed::scenarios
