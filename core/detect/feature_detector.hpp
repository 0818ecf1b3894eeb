// SPDX-License-Identifier: MIT
#pragma once

#include "core/detect/detector_options.hpp"
#include "core/detect/features.hpp"
#include "core/detect/segmentation.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// The detection pipeline: segmentation, then circles, then lines in what is no circle, arcs in what the
/// lines leave over, and legs. Keeps its buffers, so that it allocates nothing once it has seen the largest
/// scan.
class FeatureDetector {
 public:
  /// @throws InputError where the options do not validate.
  explicit FeatureDetector(const DetectorOptions& options);

  const DetectorOptions& options() const { return options_; }

  /// Features of one scan, in its sensor frame; valid until the next call. Beams without echo belong to no
  /// feature. Any number of beams, any range values.
  const Features& detect(const LaserScan& scan);

 private:
  void detect_in_segment(const Segment& segment);

  DetectorOptions options_;
  Points points_;
  std::vector<Segment> segments_;
  Features features_;
};

}  // namespace scanbed
