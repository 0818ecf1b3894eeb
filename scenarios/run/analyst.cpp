// SPDX-License-Identifier: MIT
#include "scenarios/run/analyst.hpp"

namespace scanbed::scenarios {

Analyst::Analyst(FeatureDetector& detector, const AnalystOptions& options)
    : detector_(detector), options_(options), tracker_(options.tracker), interpreter_(options.interpreter) {}

Findings Analyst::analyse(const LaserScan& scan) {
  const Features& features = detector_.detect(scan);
  Findings findings{scan, features};
  if (!options_.track && !options_.interpret) return findings;
  const std::vector<Track>& tracks = tracker_.update(scan, features);
  if (options_.track) findings.tracks = &tracks;
  if (options_.interpret) findings.scene = &interpreter_.interpret(scan, features, tracks);
  return findings;
}

}  // namespace scanbed::scenarios
