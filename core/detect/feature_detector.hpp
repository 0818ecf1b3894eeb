// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "core/detect/detector_options.hpp"
#include "core/detect/features.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed {

struct LegForest;

/// The detection pipeline: segmentation; circles; lines in what is no circle; arcs in what the lines leave
/// over; legs. Keeps its buffers, so that it allocates nothing once it has seen its largest scan.
///
/// @par Source  The paper, II. Circles come before lines, which would otherwise cut every cylinder into
/// polygons.
class FeatureDetector {
 public:
  /// With the forest that comes with it. @throws InputError where the options do not validate.
  explicit FeatureDetector(const DetectorOptions& options);

  /// @param leg_forest  tells legs where options.leg.scorer says so; must outlive the detector.
  /// @throws InputError where the options do not validate.
  FeatureDetector(const DetectorOptions& options, const LegForest& leg_forest);

  /// One that was moved from may only be assigned to or destroyed.
  FeatureDetector(FeatureDetector&&) noexcept;
  FeatureDetector& operator=(FeatureDetector&&) noexcept;
  ~FeatureDetector();

  const DetectorOptions& options() const;

  /// Takes effect from the next scan on. @throws InputError where the options do not validate.
  void set_options(const DetectorOptions& options);

  /// Features of one scan, in its sensor frame; valid until the next call. Beams without echo belong to no
  /// feature. Any number of beams and any range values are fine. It does not matter at which of its beams a
  /// scan all around begins.
  const Features& detect(const LaserScan& scan);

 private:
  class Stages;

  std::unique_ptr<Stages> stages_;  ///< apart, as their headers take seconds to compile
};

}  // namespace scanbed
