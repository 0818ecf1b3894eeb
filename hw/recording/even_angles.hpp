// SPDX-License-Identifier: MIT
#pragma once

#include "core/scan/scan_geometry.hpp"

namespace scanbed::hw {

/// By how much rounding may have changed the angles of a recorded geometry.
struct AngleRounding {
  double first_rad = 0.0;
  double step_rad = 0.0;
};

/// Undoes the rounding of a format that keeps few digits (float32, text). Sensors divide the turn evenly:
/// where a step of 2 pi / N lies within the rounding, the step is that; where then the first beam is a whole
/// number of half steps from straight ahead, within its rounding, it is that. Anything else stays as it is.
void restore_even_angles(ScanGeometry& geometry, const AngleRounding& rounding);

/// The double that a float32 stands for if what was rounded had few decimal digits, as ranges in millimetres
/// have: the shortest decimal number that rounds to it. 8.182f is 8.182, and not 8.18200016021728515625.
double shortest_decimal(float value);

}  // namespace scanbed::hw
