// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scenarios/run/findings.hpp"

namespace scanbed::scenarios {

/// Appends one scan's findings as a JSON object and a newline: what `detect` prints. Metres, seconds and
/// radians, sensor frame; features rise in their first beam; numbers are rounded to 1e-6, slope and bias of a
/// line along y are null. `from` of a scene's objects counts in the order of the printed features. The keys
/// are a public interface: further ones may be added, none renamed.
void append_feature_line(std::string& out, const Findings& findings);

}  // namespace scanbed::scenarios
