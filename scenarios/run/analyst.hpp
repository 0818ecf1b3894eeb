// SPDX-License-Identifier: MIT
#pragma once

#include "core/detect/feature_detector.hpp"
#include "core/interpret/interpreter.hpp"
#include "core/track/tracker.hpp"
#include "scenarios/run/findings.hpp"

namespace scanbed::scenarios {

/// What is done with each scan beyond its features.
struct AnalystOptions {
  bool track = false;      ///< say what was followed
  bool interpret = false;  ///< say what the scene is; tracks are followed for it too, but not said
  TrackOptions tracker;
  InterpretOptions interpreter;
};

/// Detects, follows and interprets, scan by scan.
class Analyst {
 public:
  /// @param detector  lives at least as long. @throws InputError where the options do not validate.
  Analyst(FeatureDetector& detector, const AnalystOptions& options);

  /// What there is to say of the next scan; valid until the next call, as long as `scan` lives.
  Findings analyse(const LaserScan& scan);

 private:
  FeatureDetector& detector_;
  AnalystOptions options_;
  Tracker tracker_;
  Interpreter interpreter_;
};

}  // namespace scanbed::scenarios
