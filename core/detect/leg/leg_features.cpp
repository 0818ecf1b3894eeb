// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_features.hpp"

#include <algorithm>
#include <cmath>

namespace scanbed {
namespace {

constexpr float kLegWidth_m = 0.13F;
constexpr double kMinWallWidth_m = 0.5;
constexpr double kMinSmallWidth_m = 0.008;  // of a leg that the other one hides no more may be seen
constexpr double kMaxSmallWidth_m = 0.25;
constexpr float kSmallReach_m = 1.0F;
constexpr float kMaxSmallDistance_m = 1.5F;
constexpr float kNearReach_m = 1.0F;
constexpr float kBesideReach_m = 0.5F;
constexpr float kMaxJump_m = 2.0F;
constexpr double kMaxRadius_m = 0.5;
constexpr float kOffWall_m2 = 1e6F;
constexpr float kWidthFloor_m = 0.02F;  // two echoes at one place have a shape too
constexpr float kMaxRunWidth_m = 5.0F;

constexpr std::array<std::string_view, kNumLegFeatures> kNames = {
    "num_points",    "width",           "filled",        "range",         "near_30",      "near_50",
    "near_100",      "near_wall_100",   "nearest",       "nearest_wall",  "num_small",    "nearest_small",
    "small_width",   "circle_residual", "circle_radius", "line_residual", "bow",          "inscribed",
    "tilt",          "range_std",       "step",          "fine_width",    "middle_width", "coarse_width",
    "least_jump",    "largest_jump",    "open_25",       "open_60",       "hidden",       "nearest_beside",
    "nearest_behind"};

float& at(std::array<float, kNumLegFeatures>& values, LegFeature feature) {
  return values[static_cast<std::size_t>(feature)];
}

// Second moments of a run about its centroid, per point.
struct Moments {
  double x, y;        // centroid
  double xx, xy, yy;  // covariance of the points
  double xz, yz, zz;  // with z = x^2 + y^2
  double mean_z;
};

Moments moments_of(const EchoSums& a, const EchoSums& b, int n) {
  const double inv = 1.0 / n;
  Moments m{};
  m.x = (b.x - a.x) * inv;
  m.y = (b.y - a.y) * inv;
  const double sum_xx = (b.xx - a.xx) * inv;
  const double sum_yy = (b.yy - a.yy) * inv;
  m.mean_z = sum_xx + sum_yy;
  m.xx = std::max(0.0, sum_xx - m.x * m.x);
  m.yy = std::max(0.0, sum_yy - m.y * m.y);
  m.xy = (b.xy - a.xy) * inv - m.x * m.y;
  m.xz = (b.xz - a.xz) * inv - m.x * m.mean_z;
  m.yz = (b.yz - a.yz) * inv - m.y * m.mean_z;
  m.zz = (b.zz - a.zz) * inv - m.mean_z * m.mean_z;
  return m;
}

struct CircleShape {
  float residual_m = 0.0F;
  float radius_m = static_cast<float>(kMaxRadius_m);
};

// Least squares of z = 2 a x + 2 b y + c; the residual of z over the diameter is that of the radius.
CircleShape circle_of(const Moments& m, int n) {
  const double det = m.xx * m.yy - m.xy * m.xy;
  if (n < 3 || det <= 1e-12) return {};
  const double a = (m.xz * m.yy - m.yz * m.xy) / det / 2;
  const double b = (m.yz * m.xx - m.xz * m.xy) / det / 2;
  const double off_x = a - m.x;
  const double off_y = b - m.y;
  const double radius = std::sqrt(off_x * off_x + off_y * off_y + m.xx + m.yy);
  const double residual2 = std::max(0.0, m.zz - 2.0 * a * m.xz - 2.0 * b * m.yz);
  const double signed_radius = std::min(radius, kMaxRadius_m);
  const bool is_behind = off_x * m.x + off_y * m.y >= 0.0;
  // Three points lie on a circle: what the sums leave is rounding, and no threshold shall tell by that.
  const double residual_m = n > 3 ? std::sqrt(residual2) / (2.0 * radius) : 0.0;
  return {static_cast<float>(residual_m), static_cast<float>(is_behind ? signed_radius : -signed_radius)};
}

float line_residual_m(const Moments& m) {
  const double half = (m.xx - m.yy) / 2;
  const double least = (m.xx + m.yy) / 2 - std::sqrt(half * half + m.xy * m.xy);
  return static_cast<float>(std::sqrt(std::max(0.0, least)));
}

// Cosine of the angle at echo k between the ends of the run; points that coincide see them straight ahead.
float inscribed_cosine(const LegBeams& beams, const EchoRun& run, int k) {
  const auto x = [&](int i) { return static_cast<float>(beams.echo_x_m[i] - beams.echo_x_m[k]); };
  const auto y = [&](int i) { return static_cast<float>(beams.echo_y_m[i] - beams.echo_y_m[k]); };
  const float ax = x(run.first), ay = y(run.first), bx = x(run.last), by = y(run.last);
  const float lengths = (ax * ax + ay * ay) * (bx * bx + by * by);
  return lengths > 0.0F ? (ax * bx + ay * by) / std::sqrt(lengths) : -1.0F;
}

float mean_inscribed_cosine(const LegBeams& beams, const EchoRun& run) {
  if (run.size() < 3) return -1.0F;
  const int quarter = std::max(1, (run.size() - 1) / 4);
  // With an even number of echoes the middle lies between two.
  const int middle = (run.size() - 1) / 2;
  const float ends =
      inscribed_cosine(beams, run, run.first + quarter) + inscribed_cosine(beams, run, run.last - quarter);
  const float middles =
      inscribed_cosine(beams, run, run.first + middle) + inscribed_cosine(beams, run, run.last - middle);
  return (ends + middles / 2) / 3;
}

// How much farther than `range_m` the beam sees; 0 beyond the edge of view.
float jump_m(const LegBeams& beams, int beam, double range_m) {
  if (beam < 0 || beam >= beams.num_beams) return 0.0F;
  return std::clamp(beams.range_m[beam] - static_cast<float>(range_m), -kMaxJump_m, kMaxJump_m);
}

// Accumulators of so many lanes, which are added up in the end: the compiler makes vectors of them.
constexpr int kLanes = LegBeamReader::kBlock;
using Lanes = std::array<float, kLanes>;

float sum(const Lanes& lanes) {
  float total = 0.0F;
  for (const float lane : lanes) total += lane;
  return total;
}

float least(const Lanes& lanes) {
  return *std::min_element(lanes.begin(), lanes.end());
}

}  // namespace

std::string_view name_of(LegFeature feature) {
  return kNames[static_cast<std::size_t>(feature)];
}

Eigen::Vector2d centroid_m(const LegBeams& beams, const EchoRun& run) {
  const EchoSums& a = beams.sums[run.first];
  const EchoSums& b = beams.sums[run.last + 1];
  return Eigen::Vector2d(b.x - a.x, b.y - a.y) / run.size();
}

void LegFeatureTable::resize(int num_candidates) {
  num_candidates_ = num_candidates;
  stride_ = num_padded();
  values_.assign(static_cast<std::size_t>(stride_) * kNumLegFeatures, 0.0F);
}

void LegFeatureReader::mark_surroundings(const LegBeams& beams, const LegSegmentation& segmentation) {
  off_wall_m2_.assign(beams.range_m.size(), kOffWall_m2);
  small_runs_.clear();
  for (std::size_t i = 0; i < segmentation.runs.size(); ++i) {
    const EchoRun& run = segmentation.runs[i];
    const double width_m = segmentation.width_m[i];
    if (width_m > kMinWallWidth_m) {
      for (int k = run.first; k <= run.last; ++k) off_wall_m2_[beams.beam[k]] = 0.0F;
    } else if (run.size() >= 2 && width_m >= kMinSmallWidth_m && width_m <= kMaxSmallWidth_m) {
      const Eigen::Vector2d p_m = centroid_m(beams, run);
      small_runs_.push_back(
          {run, static_cast<float>(p_m.x()), static_cast<float>(p_m.y()), static_cast<float>(width_m)});
    }
  }
}

void LegFeatureReader::read_shape(const LegBeams& beams, const EchoRun& run, Values& values) {
  const EchoSums& a = beams.sums[run.first];
  const EchoSums& b = beams.sums[run.last + 1];
  const int n = run.size();
  const Moments m = moments_of(a, b, n);
  const double mean_range_m = (b.range - a.range) / n;
  x_m_ = static_cast<float>(m.x);
  y_m_ = static_cast<float>(m.y);
  range_m_ = static_cast<float>(mean_range_m);
  spacing_m_ = static_cast<float>(mean_range_m * beams.step_rad);
  const double dx = beams.echo_x_m[run.last] - beams.echo_x_m[run.first];
  const double dy = beams.echo_y_m[run.last] - beams.echo_y_m[run.first];
  const double chord_m = std::sqrt(dx * dx + dy * dy);
  const auto width_m = static_cast<float>(chord_m);
  at(values, LegFeature::kNumPoints) = static_cast<float>(n);
  at(values, LegFeature::kWidth) = width_m;
  at(values, LegFeature::kFilled) = static_cast<float>(n) * spacing_m_ / kLegWidth_m;
  at(values, LegFeature::kRange) = range_m_;
  const CircleShape circle = circle_of(m, n);
  at(values, LegFeature::kCircleResidual) = circle.residual_m;
  at(values, LegFeature::kCircleRadius) = circle.radius_m;
  // Two points lie on a line, as three do on a circle.
  at(values, LegFeature::kLineResidual) = n > 2 ? line_residual_m(m) : 0.0F;
  // Distance of the centroid before the chord; the sensor is at the origin.
  const double side = dx * (m.y - beams.echo_y_m[run.first]) - dy * (m.x - beams.echo_x_m[run.first]);
  const double sensor_side = dy * beams.echo_x_m[run.first] - dx * beams.echo_y_m[run.first];
  const double bow_m = n > 2 && chord_m > 0.0 ? std::abs(side) / chord_m : 0.0;
  at(values, LegFeature::kBow) =
      static_cast<float>(side * sensor_side >= 0.0 ? bow_m : -bow_m) / (width_m + kWidthFloor_m);
  at(values, LegFeature::kInscribed) = mean_inscribed_cosine(beams, run);
  const double ends_m = beams.echo_range_m[run.last] - beams.echo_range_m[run.first];
  at(values, LegFeature::kTilt) = static_cast<float>(std::abs(ends_m)) / (width_m + kWidthFloor_m);
  at(values, LegFeature::kRangeStd) =
      static_cast<float>(std::sqrt(std::max(0.0, (b.range2 - a.range2) / n - mean_range_m * mean_range_m)));
  const double step2 = (b.step2 - beams.sums[run.first + 1].step2) / (n - 1);
  at(values, LegFeature::kStep) = static_cast<float>(std::sqrt(std::max(0.0, step2)));
}

void LegFeatureReader::read_small_neighbours(const EchoRun& run, Values& values) const {
  int num_small = 0;
  float nearest_m2 = kMaxSmallDistance_m * kMaxSmallDistance_m;
  float width_m = -1.0F;
  for (const SmallRun& small : small_runs_) {
    if (small.run.last >= run.first && small.run.first <= run.last) continue;
    const float dx = small.x_m - x_m_;
    const float dy = small.y_m - y_m_;
    const float distance_m2 = dx * dx + dy * dy;
    if (distance_m2 < kSmallReach_m * kSmallReach_m) ++num_small;
    if (distance_m2 >= nearest_m2) continue;
    nearest_m2 = distance_m2;
    width_m = small.width_m;
  }
  at(values, LegFeature::kNumSmall) = static_cast<float>(num_small);
  at(values, LegFeature::kNearestSmall) = std::sqrt(nearest_m2);
  at(values, LegFeature::kSmallWidth) = width_m;
}

void LegFeatureReader::read_near(const LegBeams& beams, const EchoRun& run, Values& values) {
  const int own_first = beams.beam[run.first];
  const int own_last = beams.beam[run.last];
  // Beams farther than this from the middle pass all that is within reach.
  int first = 0;
  int last = beams.num_beams - 1;
  const float center_m = std::sqrt(x_m_ * x_m_ + y_m_ * y_m_);
  if (center_m > 1.01F * kNearReach_m) {
    const double half_rad = std::asin(static_cast<double>(kNearReach_m / center_m));
    const int half = static_cast<int>(half_rad / beams.step_rad) + 2;
    // The centroid lies between the ends.
    first = std::max(0, own_first - half);
    last = std::min(last, own_last + half);
  }
  Lanes near30{}, near50{}, near100{}, wall100{}, nearest, nearest_wall;
  nearest.fill(kNearReach_m * kNearReach_m);
  nearest_wall.fill(kNearReach_m * kNearReach_m);
  const auto scan_beams = [&](int from, int to) {
    for (int begin = from; begin <= to; begin += kLanes) {
      const float* x = beams.x_m.data() + begin;
      const float* y = beams.y_m.data() + begin;
      const float* off_wall = off_wall_m2_.data() + begin;
      for (int lane = 0; lane < kLanes; ++lane) {
        const float dx = x[lane] - x_m_;
        const float dy = y[lane] - y_m_;
        // Past the end of the window nothing is near.
        const float past = begin + lane > to ? kOffWall_m2 : 0.0F;
        const float d2 = dx * dx + dy * dy + past;
        const float wall2 = d2 + off_wall[lane];
        near30[lane] += d2 < 0.09F ? 1.0F : 0.0F;
        near50[lane] += d2 < 0.25F ? 1.0F : 0.0F;
        near100[lane] += d2 < 1.0F ? 1.0F : 0.0F;
        wall100[lane] += wall2 < 1.0F ? 1.0F : 0.0F;
        nearest[lane] = d2 < nearest[lane] ? d2 : nearest[lane];
        nearest_wall[lane] = wall2 < nearest_wall[lane] ? wall2 : nearest_wall[lane];
      }
    }
  };
  scan_beams(first, own_first - 1);
  scan_beams(own_last + 1, last);
  at(values, LegFeature::kNear30) = sum(near30) * spacing_m_;
  at(values, LegFeature::kNear50) = sum(near50) * spacing_m_;
  at(values, LegFeature::kNear100) = sum(near100) * spacing_m_;
  at(values, LegFeature::kNearWall100) = sum(wall100) * spacing_m_;
  at(values, LegFeature::kNearest) = std::sqrt(least(nearest));
  at(values, LegFeature::kNearestWall) = std::sqrt(least(nearest_wall));
}

void LegFeatureReader::read_beside(const LegBeams& beams, const EchoRun& run, Values& values) {
  const int own_first = beams.beam[run.first];
  const int own_last = beams.beam[run.last];
  const double reach = std::ceil(static_cast<double>(kBesideReach_m / spacing_m_));
  const int half = static_cast<int>(std::clamp(reach, 1.0, static_cast<double>(beams.num_beams)));
  const int first = std::max(0, own_first - half);
  const int last = std::min(beams.num_beams - 1, own_last + half);
  Lanes open25{}, open60{}, hidden{}, nearest, behind;
  nearest.fill(kMaxJump_m);
  behind.fill(kMaxJump_m);
  const auto look = [&](float range_m, int lane) {
    const float farther = range_m - range_m_;
    const float off = std::abs(farther);
    const float off_behind = farther > -0.1F ? farther : kMaxJump_m;
    open25[lane] += farther > 0.25F ? 1.0F : 0.0F;
    open60[lane] += farther > 0.6F ? 1.0F : 0.0F;
    hidden[lane] += farther < -0.15F ? 1.0F : 0.0F;
    nearest[lane] = off < nearest[lane] ? off : nearest[lane];
    behind[lane] = off_behind < behind[lane] ? off_behind : behind[lane];
  };
  const auto scan_beams = [&](int from, int to) {
    int begin = from;
    for (; begin + kLanes <= to + 1; begin += kLanes) {
      const float* range = beams.range_m.data() + begin;
      for (int lane = 0; lane < kLanes; ++lane) look(range[lane], lane);
    }
    for (; begin <= to; ++begin) look(beams.range_m[begin], 0);
  };
  scan_beams(first, own_first - 1);
  scan_beams(own_last + 1, last);
  const int in_view = (own_first - first) + (last - own_last);
  const float each = in_view > 0 ? 1.0F / static_cast<float>(in_view) : 0.0F;
  const float unknown = in_view > 0 ? 0.0F : 0.5F;
  at(values, LegFeature::kOpen25) = unknown + sum(open25) * each;
  at(values, LegFeature::kOpen60) = unknown + sum(open60) * each;
  at(values, LegFeature::kHidden) = sum(hidden) * each;
  at(values, LegFeature::kNearestBeside) = least(nearest);
  at(values, LegFeature::kNearestBehind) = least(behind);
  const float left_m = jump_m(beams, own_first - 1, beams.echo_range_m[run.first]);
  const float right_m = jump_m(beams, own_last + 1, beams.echo_range_m[run.last]);
  at(values, LegFeature::kLeastJump) = std::min(left_m, right_m);
  at(values, LegFeature::kLargestJump) = std::max(left_m, right_m);
}

void LegFeatureReader::read(const LegBeams& beams, const LegCandidates& candidates, LegFeatureTable& table) {
  mark_surroundings(beams, candidates.segmentations[1]);
  const int num_candidates = static_cast<int>(candidates.runs.size());
  table.resize(num_candidates);
  constexpr std::array kWidths = {LegFeature::kFineWidth, LegFeature::kMiddleWidth, LegFeature::kCoarseWidth};
  Values values{};
  for (int c = 0; c < num_candidates; ++c) {
    const EchoRun& run = candidates.runs[c];
    read_shape(beams, run, values);
    read_small_neighbours(run, values);
    read_near(beams, run, values);
    read_beside(beams, run, values);
    for (int i = 0; i < LegCandidates::kNumSegmentations; ++i) {
      const LegSegmentation& segmentation = candidates.segmentations[i];
      const double width_m = segmentation.width_m[segmentation.run_of_echo[(run.first + run.last) / 2]];
      at(values, kWidths[i]) = std::min(static_cast<float>(width_m), kMaxRunWidth_m);
    }
    for (int f = 0; f < kNumLegFeatures; ++f) table.row(f)[c] = values[f];
  }
}

}  // namespace scanbed
