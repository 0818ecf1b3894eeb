// SPDX-License-Identifier: MIT
#include "core/detect/feature_detector.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "core/detect/circle_detector.hpp"
#include "core/detect/full_turn.hpp"
#include "core/detect/leg/forest_leg_detector.hpp"
#include "core/detect/leg/leg_forest.hpp"
#include "core/detect/leg_detector.hpp"
#include "core/detect/line_corner.hpp"
#include "core/detect/line_detector.hpp"
#include "core/detect/points.hpp"
#include "core/detect/robust/surface_parser.hpp"
#include "core/detect/segmentation.hpp"

namespace scanbed {
namespace {

const DetectorOptions& validated(const DetectorOptions& options) {
  options.validate();
  return options;
}

}  // namespace

class FeatureDetector::Stages {
 public:
  Stages(const DetectorOptions& options, const LegForest& leg_forest)
      : options_(validated(options)), line_detector_(options.line), forest_leg_detector_(leg_forest) {}

  const DetectorOptions& options() const { return options_; }
  void set_options(const DetectorOptions& options);
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

void FeatureDetector::Stages::set_options(const DetectorOptions& options) {
  options_ = validated(options);
  line_detector_.set_options(options.line);
}

const Features& FeatureDetector::Stages::detect(const LaserScan& scan) {
  features_.clear();
  detect_unrolled(full_turn_.unroll(scan));
  full_turn_.roll(features_);
  return features_;
}

void FeatureDetector::Stages::detect_unrolled(const LaserScan& scan) {
  const bool is_paper = options_.pipeline == Pipeline::kPaper;
  const bool by_rules = options_.leg.scorer == LegScorer::kRules;
  if (is_paper || (by_rules && options_.leg.enabled)) detect_in_segments(scan);
  if (!is_paper) detect_surfaces(scan, options_, features_);
  if (options_.leg.enabled && !by_rules) detect_legs_by_forest(scan);
  if (!is_paper) end_at_corners(features_.lines, scan.geometry);
  if (options_.line.method == LineMethod::kOff) features_.lines.clear();
  if (options_.circle.method == CircleMethod::kOff) features_.circles.clear();
}

// The forest asks which circles there are, and knows those of the robust pipeline.
void FeatureDetector::Stages::detect_legs_by_forest(const LaserScan& scan) {
  const bool is_paper = options_.pipeline == Pipeline::kPaper;
  if (is_paper) {
    surfaces_.clear();
    detect_surfaces(scan, robust_options(), surfaces_);
  }
  forest_leg_detector_.detect(scan, is_paper ? surfaces_ : features_, options_.leg, features_);
}

void FeatureDetector::Stages::detect_in_segments(const LaserScan& scan) {
  projector_.project(scan, points_);
  segment_points(points_, options_.segmentation, segments_);
  for (const Segment& segment : segments_) {
    if (options_.pipeline == Pipeline::kPaper) detect_in_segment(segment);
    if (options_.leg.scorer != LegScorer::kRules) continue;
    const std::optional<Leg> leg = detect_leg(scan, points_, segment, options_.leg);
    if (leg) append_by_score(*leg, options_.leg, features_);
  }
}

void FeatureDetector::Stages::detect_surfaces(const LaserScan& scan, const DetectorOptions& options,
                                              Features& features) {
  echo_reader_.read(scan, options.surface, echoes_);
  surface_parser_.parse(echoes_, scan, options, features);
  const auto rising = [](const auto& a, const auto& b) { return a.beams.first < b.beams.first; };
  std::sort(features.lines.begin(), features.lines.end(), rising);
  std::sort(features.circles.begin(), features.circles.end(), rising);
  std::sort(features.doubtful_circles.begin(), features.doubtful_circles.end(), rising);
}

void FeatureDetector::Stages::detect_in_segment(const Segment& segment) {
  std::optional<Circle> circle;
  if (options_.circle.method != CircleMethod::kOff) circle = detect_circle(points_, segment, options_.circle);
  if (circle) {
    features_.circles.push_back(*circle);
  } else {
    const int first_line = static_cast<int>(features_.lines.size());
    line_detector_.detect(points_, segment, features_.lines);
    detect_arcs_beside_lines(segment, first_line);
  }
}

void FeatureDetector::Stages::detect_arcs_beside_lines(const Segment& segment, int first_line) {
  const int num_lines = static_cast<int>(features_.lines.size());
  if (options_.circle.method == CircleMethod::kOff || !options_.circle.in_lines || first_line == num_lines) {
    return;
  }
  const int first_beam = points_.beam[segment.first];
  const auto index_of = [&](int beam) { return segment.first + beam - first_beam; };
  int first_left_over = segment.first;
  for (int i = first_line; i <= num_lines; ++i) {
    const bool past_last = i == num_lines;
    const Segment left_over{first_left_over,
                            past_last ? segment.last : index_of(features_.lines[i].beams.first) - 1};
    if (const auto arc = detect_circle(points_, left_over, options_.circle))
      features_.circles.push_back(*arc);
    if (!past_last) first_left_over = index_of(features_.lines[i].beams.last) + 1;
  }
}

FeatureDetector::FeatureDetector(const DetectorOptions& options)
    : FeatureDetector(options, trained_leg_forest()) {}

FeatureDetector::FeatureDetector(const DetectorOptions& options, const LegForest& leg_forest)
    : stages_(std::make_unique<Stages>(options, leg_forest)) {}

FeatureDetector::FeatureDetector(FeatureDetector&&) noexcept = default;
FeatureDetector& FeatureDetector::operator=(FeatureDetector&&) noexcept = default;
FeatureDetector::~FeatureDetector() = default;

const DetectorOptions& FeatureDetector::options() const {
  return stages_->options();
}

void FeatureDetector::set_options(const DetectorOptions& options) {
  stages_->set_options(options);
}

const Features& FeatureDetector::detect(const LaserScan& scan) {
  return stages_->detect(scan);
}

}  // namespace scanbed
