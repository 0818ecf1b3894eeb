// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/detect/detector_options.hpp"
#include "core/detect/features.hpp"
#include "core/detect/full_turn.hpp"
#include "core/detect/leg/forest_leg_detector.hpp"
#include "core/detect/leg/leg_forest.hpp"
#include "core/detect/line_detector.hpp"
#include "core/detect/points.hpp"
#include "core/detect/robust/surface_parser.hpp"
#include "core/detect/segmentation.hpp"
#include "core/scan/laser_scan.hpp"

namespace scanbed {

/// The detection pipeline: segmentation; circles; lines in what is no circle; arcs in what the lines leave
/// over; legs. Keeps its buffers, so that it allocates nothing once it has seen its largest scan.
///
/// @par Source  The paper, II. Circles come before lines, which would otherwise cut every cylinder into
/// polygons.
class FeatureDetector {
 public:
  /// @param leg_forest  tells legs where options.leg.scorer says so; must outlive the detector.
  /// @throws InputError where the options do not validate.
  explicit FeatureDetector(const DetectorOptions& options,
                           const LegForest& leg_forest = trained_leg_forest());

  const DetectorOptions& options() const { return options_; }

  /// Takes effect from the next scan on. @throws InputError where the options do not validate.
  void set_options(const DetectorOptions& options);

  /// Features of one scan, in its sensor frame; valid until the next call. Beams without echo belong to no
  /// feature. Any number of beams and any range values are fine. It does not matter at which of its beams a
  /// scan all around begins.
  const Features& detect(const LaserScan& scan);

 private:
  void detect_unrolled(const LaserScan& scan);
  void detect_in_segments(const LaserScan& scan);
  void detect_surfaces(const LaserScan& scan, const DetectorOptions& options, Features& features);
  void detect_legs_by_forest(const LaserScan& scan);
  void detect_in_segment(const Segment& segment);
  void detect_arcs_beside_lines(const Segment& segment, int first_line);

  DetectorOptions options_;
  PointProjector projector_;
  FullTurn full_turn_;
  LineDetector line_detector_;
  EchoReader echo_reader_;
  SurfaceParser surface_parser_;
  ForestLegDetector forest_leg_detector_;
  Echoes echoes_;
  Points points_;
  std::vector<Segment> segments_;
  Features features_;
  Features surfaces_;  ///< of the robust pipeline, where the other one is asked for
};

}  // namespace scanbed
