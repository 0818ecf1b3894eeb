// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/detect/detector_options.hpp"

namespace scanbed {

/// Names of the detectors' presets: "paper", "robust".
std::span<const std::string> preset_names();

/// A preset by its name; empty where there is none of that name.
std::optional<DetectorOptions> preset_options(std::string_view name);

}  // namespace scanbed
