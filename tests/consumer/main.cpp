// SPDX-License-Identifier: MIT
#include "core/detect/feature_detector.hpp"

// As README has it.
int main() {
  scanbed::LaserScan scan;
  scan.geometry = {.num_beams = 361, .first_rad = -1.5708, .step_rad = 0.0087266};
  scan.range_m.assign(361, scanbed::kNoEcho);
  scanbed::FeatureDetector detector(scanbed::robust_options());
  return detector.detect(scan).circles.empty() ? 0 : 1;
}
