// SPDX-License-Identifier: MIT
#include "core/detect/feature_detector.hpp"

int main() {
  return scanbed::FeatureDetector(scanbed::paper_options()).detect({}).lines.empty() ? 0 : 1;
}
