// SPDX-License-Identifier: MIT
#include "core/detect/presets.hpp"

#include <array>

namespace scanbed {
namespace {

const std::array<std::string, 2> kNames = {"paper", "robust"};

}  // namespace

std::span<const std::string> preset_names() {
  return kNames;
}

std::optional<DetectorOptions> preset_options(std::string_view name) {
  if (name == kNames[0]) return paper_options();
  if (name == kNames[1]) return robust_options();
  return std::nullopt;
}

}  // namespace scanbed
