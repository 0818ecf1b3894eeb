// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_features.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/angles.hpp"
#include "core/simd/double_lanes.hpp"

namespace scanbed {
namespace {

constexpr float kLegWidth_m = 0.13F;
constexpr double kMinWallWidth_m = 0.5;
constexpr double kMinSmallWidth_m = 0.008;  // of a leg that the other one hides no more may be seen
constexpr double kMaxSmallWidth_m = 0.25;
constexpr float kBesideReach_m = 0.5F;
constexpr double kMaxRadius_m = 0.5;
constexpr float kWidthFloor_m = 0.02F;  // two echoes at one place have a shape too
constexpr float kMaxRunWidth_m = 5.0F;
constexpr float kMaxArcRadius_m = 1.0F;
constexpr float kMaxArcShare = 4.0F;

// Moments of a run about its centroid, per point.
struct Moments {
  double x = 0.0, y = 0.0;              // centroid
  double xx = 0.0, xy = 0.0, yy = 0.0;  // covariance of the points
  double xz = 0.0, yz = 0.0, zz = 0.0;  // with z = x^2 + y^2, about the centroid too
  double range = 0.0, range_var = 0.0;
  double step2 = 0.0;  // mean square of the steps of range
};

// Centroid and mean range.
Moments means_of(const LegBeams& beams, const EchoRun& run) {
  Moments m;
  for (int k = run.first; k <= run.last; ++k) {
    m.x += beams.echo_x_m[k];
    m.y += beams.echo_y_m[k];
    m.range += beams.echo_range_m[k];
  }
  const double each = 1.0 / run.size();
  m.x *= each;
  m.y *= each;
  m.range *= each;
  return m;
}

Moments moments_of(const LegBeams& beams, const EchoRun& run) {
  Moments m = means_of(beams, run);
  // Two sums each, so that one instruction adds to both.
  Doubles xx_yy{}, xz_yz{}, xy_zz{}, range_step{};
  double sum_z = 0.0;
  const Doubles mean{m.x, m.y};
  double before = beams.echo_range_m[run.first];
  for (int k = run.first; k <= run.last; ++k) {
    const Doubles p = Doubles{beams.echo_x_m[k], beams.echo_y_m[k]} - mean;
    const Doubles squares = p * p;
    const Doubles z = squares + swapped(squares);
    const Doubles off = both_lanes(beams.echo_range_m[k]) - Doubles{m.range, before};
    before = beams.echo_range_m[k];
    xx_yy += squares;
    xz_yz += p * z;
    xy_zz += Doubles{p[0], z[0]} * Doubles{p[1], z[1]};
    range_step += off * off;
    sum_z += z[0];
  }
  const double each = 1.0 / run.size();
  const double mean_z = sum_z * each;
  m.xx = xx_yy[0] * each;
  m.yy = xx_yy[1] * each;
  m.xz = xz_yz[0] * each;
  m.yz = xz_yz[1] * each;
  m.xy = xy_zz[0] * each;
  m.zz = xy_zz[1] * each - mean_z * mean_z;
  m.range_var = range_step[0] * each;
  m.step2 = range_step[1] / (run.size() - 1);
  return m;
}

struct CircleShape {
  float residual_m = 0.0F;
  float radius_m = static_cast<float>(kMaxRadius_m);
};

// Least squares of z = 2 a x + 2 b y + c about the centroid; the residual of z over the diameter is that of
// the radius.
CircleShape circle_of(const Moments& m, int n) {
  const double det = m.xx * m.yy - m.xy * m.xy;
  if (n < 3 || det <= 1e-12) return {};
  const double a = (m.xz * m.yy - m.yz * m.xy) / det / 2;
  const double b = (m.yz * m.xx - m.xz * m.xy) / det / 2;
  const double radius = std::sqrt(a * a + b * b + m.xx + m.yy);
  const double residual2 = std::max(0.0, m.zz - 2.0 * a * m.xz - 2.0 * b * m.yz);
  const double signed_radius = std::min(radius, kMaxRadius_m);
  const bool is_behind = a * m.x + b * m.y >= 0.0;
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
  return std::clamp(beams.range_m[beam] - static_cast<float>(range_m), -LegSurroundings::kMaxJump_m,
                    LegSurroundings::kMaxJump_m);
}

// No less than asin(reach / distance), half the angle under which a disc is seen; pi from within.
double greatest_half_view_rad(float reach_m, float distance_m) {
  if (distance_m <= 1.01F * reach_m) return kPi;
  const auto s = static_cast<double>(reach_m / distance_m);
  return s * (1.0 + (kPi / 2.0 - 1.0) * s * s);
}

void read_jumps(const LegBeams& beams, const EchoRun& run, const LegFeatureColumn& values) {
  const float left_m = jump_m(beams, beams.beam[run.first] - 1, beams.echo_range_m[run.first]);
  const float right_m = jump_m(beams, beams.beam[run.last] + 1, beams.echo_range_m[run.last]);
  values.at(LegFeature::kLeastJump) = std::min(left_m, right_m);
  values.at(LegFeature::kLargestJump) = std::max(left_m, right_m);
}

void read_widths(const LegCandidates& candidates, const EchoRun& run, const LegFeatureColumn& values) {
  constexpr std::array kWidths = {LegFeature::kFineWidth, LegFeature::kMiddleWidth, LegFeature::kCoarseWidth};
  for (int i = 0; i < LegCandidates::kNumSegmentations; ++i) {
    const double width_m = candidates.segmentations[i].width_of((run.first + run.last) / 2);
    values.at(kWidths[i]) = std::min(static_cast<float>(width_m), kMaxRunWidth_m);
  }
}

}  // namespace

Eigen::Vector2d centroid_m(const LegBeams& beams, const EchoRun& run) {
  const Moments m = means_of(beams, run);
  return {m.x, m.y};
}

void LegFeatureTable::resize(int num_candidates) {
  num_candidates_ = num_candidates;
  values_.assign(static_cast<std::size_t>(num_blocks()) * kBlock * kNumLegFeatures, 0.0F);
}

void LegFeatureTable::copy(int from, int to) {
  for (int f = 0; f < kNumLegFeatures; ++f) at(f, to) = at(f, from);
}

void LegFeatureReader::mark_surroundings(const LegBeams& beams, const LegSegmentation& segmentation) {
  around_.range_m.copy(beams.range_m);
  around_.x_m.copy(beams.x_m);
  around_.y_m.copy(beams.y_m);
  around_.off_wall_m2.fill(beams.range_m.size(), LegSurroundings::kFar_m2);
  small_runs_.clear();
  for (std::size_t i = 0; i < segmentation.runs.size(); ++i) {
    const EchoRun& run = segmentation.runs[i];
    const double width_m = segmentation.width_m[i];
    if (width_m > kMinWallWidth_m) {
      // Beams without echo among them are far from everything.
      std::fill(around_.off_wall_m2.from(beams.beam[run.first]),
                around_.off_wall_m2.from(beams.beam[run.last] + 1), 0.0F);
    } else if (run.size() >= 2 && width_m >= kMinSmallWidth_m && width_m <= kMaxSmallWidth_m) {
      const BeamSpan span{beams.beam[run.first], beams.beam[run.last]};
      if (!beams.counts(span)) continue;
      const Eigen::Vector2f p_m = centroid_m(beams, run).cast<float>();
      small_runs_.push_back({{span, p_m.x(), p_m.y()}, static_cast<float>(width_m)});
    }
  }
}

void LegFeatureReader::read_shape(const LegBeams& beams, const EchoRun& run, int candidate, Values values) {
  const int n = run.size();
  const Moments m = moments_of(beams, run);
  const auto range_m = static_cast<float>(m.range);
  const auto spacing_m = static_cast<float>(m.range * beams.step_rad);
  places_[candidate] = {
      {beams.beam[run.first], beams.beam[run.last]}, static_cast<float>(m.x), static_cast<float>(m.y)};
  extents_[candidate] = {range_m, spacing_m};
  const double dx = beams.echo_x_m[run.last] - beams.echo_x_m[run.first];
  const double dy = beams.echo_y_m[run.last] - beams.echo_y_m[run.first];
  const double chord_m = std::sqrt(dx * dx + dy * dy);
  const auto width_m = static_cast<float>(chord_m);
  values.at(LegFeature::kNumPoints) = static_cast<float>(n);
  values.at(LegFeature::kWidth) = width_m;
  values.at(LegFeature::kFilled) = static_cast<float>(n) * spacing_m / kLegWidth_m;
  values.at(LegFeature::kRange) = range_m;
  const CircleShape circle = circle_of(m, n);
  values.at(LegFeature::kCircleResidual) = circle.residual_m;
  values.at(LegFeature::kCircleRadius) = circle.radius_m;
  // Two points lie on a line, as three do on a circle.
  values.at(LegFeature::kLineResidual) = n > 2 ? line_residual_m(m) : 0.0F;
  // Distance of the centroid before the chord; the sensor is at the origin.
  const double side = dx * (m.y - beams.echo_y_m[run.first]) - dy * (m.x - beams.echo_x_m[run.first]);
  const double sensor_side = dy * beams.echo_x_m[run.first] - dx * beams.echo_y_m[run.first];
  const double bow_m = n > 2 && chord_m > 0.0 ? std::abs(side) / chord_m : 0.0;
  values.at(LegFeature::kBow) =
      static_cast<float>(side * sensor_side >= 0.0 ? bow_m : -bow_m) / (width_m + kWidthFloor_m);
  values.at(LegFeature::kInscribed) = mean_inscribed_cosine(beams, run);
  const double ends_m = beams.echo_range_m[run.last] - beams.echo_range_m[run.first];
  values.at(LegFeature::kTilt) = static_cast<float>(std::abs(ends_m)) / (width_m + kWidthFloor_m);
  values.at(LegFeature::kRangeStd) = static_cast<float>(std::sqrt(m.range_var));
  values.at(LegFeature::kStep) = static_cast<float>(std::sqrt(m.step2));
}

void LegFeatureReader::read_small_neighbours(LegFeatureTable& table) const {
  LegPlaceLanes own;
  SmallNeighbours found;
  for (int i = 0; i < table.num_blocks(); ++i) {
    own.read(std::span(places_).subspan(static_cast<std::size_t>(i) * kNumLanes));
    find_small(instructions_, small_runs_, own, found);
    take_square_root(found.nearest_m2);
    table.write(LegFeature::kNumSmall, i, __builtin_convertvector(found.num, Floats));
    table.write(LegFeature::kNearestSmall, i, found.nearest_m2);
    table.write(LegFeature::kSmallWidth, i, found.width_m);
  }
}

// For all candidates before any is looked around: how far a loop goes must be known long before it starts,
// for the CPU cannot foretell it.
void LegFeatureReader::find_extents(const LegBeams& beams) {
  for (std::size_t c = 0; c < places_.size(); ++c) {
    const LegPlace& own = places_[c];
    // Beams farther than this from the ends pass all that is within reach: the centroid lies between the
    // ends.
    const float center_m = std::sqrt(own.x_m * own.x_m + own.y_m * own.y_m);
    const double half_rad = greatest_half_view_rad(LegSurroundings::kNearReach_m, center_m);
    const double near = std::min(half_rad / beams.step_rad + 2.0, 1.0 * beams.num_beams);
    extents_[c].near = beams.around(own.beams, static_cast<int>(near));
    const double reach = std::ceil(static_cast<double>(kBesideReach_m / extents_[c].spacing_m));
    const double beside = std::clamp(reach, 1.0, static_cast<double>(beams.num_beams));
    extents_[c].beside = beams.around(own.beams, static_cast<int>(beside));
  }
}

void LegFeatureReader::read_near(int candidate, Values values) const {
  const Extent& extent = extents_[candidate];
  const NearEchoes near =
      count_near(instructions_, {around_, places_[candidate], extent.range_m}, extent.near);
  values.at(LegFeature::kNear30) = static_cast<float>(near.num_within30) * extent.spacing_m;
  values.at(LegFeature::kNear50) = static_cast<float>(near.num_within50) * extent.spacing_m;
  values.at(LegFeature::kNear100) = static_cast<float>(near.num_within100) * extent.spacing_m;
  values.at(LegFeature::kNearWall100) = static_cast<float>(near.num_wall100) * extent.spacing_m;
  values.at(LegFeature::kNearest) = std::sqrt(near.nearest_m2);
  values.at(LegFeature::kNearestWall) = std::sqrt(near.nearest_wall_m2);
}

void LegFeatureReader::read_beside(int candidate, Values values) const {
  const BeamSpan& own = places_[candidate].beams;
  const BeamSpan& all = extents_[candidate].beside;
  const BesideBeams beside =
      look_beside(instructions_, {around_, places_[candidate], extents_[candidate].range_m}, all);
  const int in_view = (own.first - all.first) + (all.last - own.last);
  const float each = in_view > 0 ? 1.0F / static_cast<float>(in_view) : 0.0F;
  const float unknown = in_view > 0 ? 0.0F : 0.5F;
  values.at(LegFeature::kOpen25) = unknown + static_cast<float>(beside.num_open25) * each;
  values.at(LegFeature::kOpen60) = unknown + static_cast<float>(beside.num_open60) * each;
  values.at(LegFeature::kHidden) = static_cast<float>(beside.num_hidden) * each;
  values.at(LegFeature::kNearestBeside) = beside.nearest_m;
  values.at(LegFeature::kNearestBehind) = beside.behind_m;
}

void LegFeatureReader::read_arc(const LegBeams& beams, const EchoRun& run, Values values) const {
  // With an even number of echoes the middle lies between two.
  const LegArc* before = arcs_.at(beams.beam[(run.first + run.last) / 2]);
  const LegArc* after = arcs_.at(beams.beam[(run.first + run.last + 1) / 2]);
  const LegArc none{.num_echoes = run.size()};
  const LegArc& own = before != nullptr && before == after ? *before : none;
  const float share = static_cast<float>(run.size()) / static_cast<float>(own.num_echoes);
  values.at(LegFeature::kArcRadius) = std::min(own.radius_m, kMaxArcRadius_m);
  values.at(LegFeature::kArcShare) = std::min(share, kMaxArcShare);
}

void LegFeatureReader::read(const LegBeams& beams, const LegCandidates& candidates, const Features& surfaces,
                            LegFeatureTable& table) {
  mark_surroundings(beams, candidates.segmentations[1]);
  arcs_.mark(beams, surfaces);
  const int num_candidates = static_cast<int>(candidates.runs.size());
  table.resize(num_candidates);
  places_.resize(num_candidates);
  extents_.resize(num_candidates);
  for (int c = 0; c < num_candidates; ++c) read_shape(beams, candidates.runs[c], c, table.column(c));
  find_extents(beams);
  for (int c = 0; c < num_candidates; ++c) {
    const Values values = table.column(c);
    read_near(c, values);
    read_beside(c, values);
    read_arc(beams, candidates.runs[c], values);
    read_jumps(beams, candidates.runs[c], values);
    read_widths(candidates, candidates.runs[c], values);
  }
  read_small_neighbours(table);
}

}  // namespace scanbed
