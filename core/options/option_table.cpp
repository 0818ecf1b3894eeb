// SPDX-License-Identifier: MIT
#include "core/options/option_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <type_traits>

namespace scanbed {
namespace {

using All = AnalysisOptions;
using enum OptionReader;

// One row: the field that the members lead to, its name and its effect.
template <auto... kMembers>
Option row(std::string_view path, std::string_view effect, OptionReader reader = kBoth,
           std::span<const std::string_view> words = {}) {
  using Field = std::remove_cvref_t<decltype((std::declval<All>().*....*kMembers))>;
  OptionKind kind = OptionKind::kReal;
  if constexpr (std::is_same_v<Field, bool>) {
    kind = OptionKind::kFlag;
  } else if constexpr (std::is_same_v<Field, int>) {
    kind = OptionKind::kWhole;
  } else if constexpr (std::is_enum_v<Field>) {
    kind = OptionKind::kChoice;
  }
  return {path,
          effect,
          kind,
          reader,
          words,
          [](const All& options) { return static_cast<double>((options.*....*kMembers)); },
          [](All& options, double value) {
            if constexpr (std::is_enum_v<Field>) {
              (options.*....*kMembers) = static_cast<Field>(static_cast<int>(value));
            } else {
              (options.*....*kMembers) = static_cast<Field>(value);
            }
          }};
}

template <auto kMember>
Option segmentation(std::string_view path, std::string_view effect) {
  return row<&All::detector, &DetectorOptions::segmentation, kMember>(path, effect, kSegments);
}

template <auto kMember>
Option circle(std::string_view path, std::string_view effect, OptionReader reader = kPaper) {
  return row<&All::detector, &DetectorOptions::circle, kMember>(path, effect, reader);
}

template <auto kMember>
Option line(std::string_view path, std::string_view effect, OptionReader reader = kPaper) {
  return row<&All::detector, &DetectorOptions::line, kMember>(path, effect, reader);
}

template <auto kMember>
Option leg(std::string_view path, std::string_view effect, OptionReader reader = kLegRules) {
  return row<&All::detector, &DetectorOptions::leg, kMember>(path, effect, reader);
}

template <auto kMember>
Option surface(std::string_view path, std::string_view effect) {
  return row<&All::detector, &DetectorOptions::surface, kMember>(path, effect, kRobust);
}

template <auto kMember>
Option interpret(std::string_view path, std::string_view effect) {
  return row<&All::interpret, kMember>(path, effect, kInterpretation);
}

template <auto kMember>
Option track(std::string_view path, std::string_view effect) {
  return row<&All::track, kMember>(path, effect, kTracking);
}

const std::array kTable = {
    row<&All::detector, &DetectorOptions::pipeline>(
        "pipeline", "the paper's detectors, or lines and circles by comparing models", kBoth, kPipelineWords),

    segmentation<&SegmentationOptions::max_gap_m>(
        "segmentation.max_gap_m", "neighbouring points farther apart belong to different segments"),
    segmentation<&SegmentationOptions::min_points>("segmentation.min_points", "smaller segments are dropped"),

    row<&All::detector, &DetectorOptions::circle, &CircleOptions::method>(
        "circle.method", "off, or on by any other word in the robust pipeline", kBoth, kCircleMethodWords),
    circle<&CircleOptions::min_points>("circle.min_points", "fewer points make no circle", kBoth),
    circle<&CircleOptions::max_std_rad>(
        "circle.max_std_rad", "of the inscribed angles; above 0.15 also arc-like shapes are circles"),
    circle<&CircleOptions::min_average_rad>("circle.min_average_rad", "of the inscribed angles"),
    circle<&CircleOptions::max_average_rad>("circle.max_average_rad",
                                            "of the inscribed angles; larger: flatter arcs are circles too"),
    circle<&CircleOptions::min_length_m>("circle.min_length_m", "shorter segments are not tried"),
    circle<&CircleOptions::max_length_m>("circle.max_length_m", "longer segments are not tried"),
    circle<&CircleOptions::prerequisite>("circle.prerequisite",
                                         "test the middle point first: saves time, drops flat segments"),
    circle<&CircleOptions::min_depth_ratio>("circle.min_depth_ratio",
                                            "depth of the middle point per length of the chord"),
    circle<&CircleOptions::max_depth_ratio>("circle.max_depth_ratio",
                                            "depth of the middle point per length of the chord"),
    circle<&CircleOptions::in_lines>("circle.in_lines", "look for arcs in what the lines leave over"),

    row<&All::detector, &DetectorOptions::line, &LineOptions::method>(
        "line.method", "off, or on by any other word in the robust pipeline", kBoth, kLineMethodWords),
    line<&LineOptions::min_points>("line.min_points", "fewer points make no line", kBoth),
    line<&LineOptions::min_length_m>("line.min_length_m", "shorter lines are not reported", kBoth),
    line<&LineOptions::max_error_m>("line.max_error_m",
                                    "a run splits where a point lies farther off its line"),
    line<&LineOptions::max_average_deviation_rad>("line.max_average_deviation_rad",
                                                  "of inscribed angles from half a turn"),
    line<&LineOptions::max_std_rad>("line.max_std_rad", "of the inscribed angles of a line"),

    leg<&LegOptions::enabled>("leg.enabled", "look for legs", kBoth),
    row<&All::detector, &DetectorOptions::leg, &LegOptions::scorer>(
        "leg.scorer", "tells legs by rules of size and shape, or by a forest that sees the surroundings too",
        kBoth, kLegScorerWords),
    leg<&LegOptions::min_score>("leg.min_score", "legs of a lower score are not reported ...", kBoth),
    leg<&LegOptions::min_doubtful_score>("leg.min_doubtful_score",
                                         "... but tracking may follow them from this one on; 1: none", kBoth),
    leg<&LegOptions::min_width_m>("leg.min_width_m", "rules: chord of the segment"),
    leg<&LegOptions::max_width_m>("leg.max_width_m", "rules: chord of the segment"),
    leg<&LegOptions::min_points>("leg.min_points", "rules: fewer points make no leg"),
    leg<&LegOptions::min_depth_ratio>("leg.min_depth_ratio",
                                      "rules: depth of the middle point per length of the chord"),
    leg<&LegOptions::max_depth_ratio>("leg.max_depth_ratio",
                                      "rules: depth of the middle point per length of the chord"),

    surface<&SurfaceOptions::min_gap_m>("surface.min_gap_m",
                                        "neighbours nearer than this plus 3 sigma lie on one surface"),
    surface<&SurfaceOptions::gap_spacings>("surface.gap_spacings",
                                           "widens that bound by so many spacings of beams"),
    surface<&SurfaceOptions::max_grazing_step_m>("surface.max_grazing_step_m",
                                                 "between beams of a wall seen at grazing incidence"),
    surface<&SurfaceOptions::max_speck_beams>("surface.max_speck_beams",
                                              "so many nearer or missing beams do not cut a surface"),
    surface<&SurfaceOptions::min_noise_m>("surface.min_noise_m", "sigma of ranges is estimated as no less"),
    surface<&SurfaceOptions::max_noise_m>("surface.max_noise_m", "sigma of ranges is estimated as no more"),
    surface<&SurfaceOptions::noise_ratio>(
        "surface.noise_ratio", "so much sigma a metre of range on top; 0.01 for lasers that triangulate"),
    surface<&SurfaceOptions::noise_inflation>("surface.noise_inflation",
                                              "of the estimated sigma; higher: fewer and rounder pieces"),
    surface<&SurfaceOptions::line_price>("surface.line_price",
                                         "chi squared that a line has to save; higher: fewer, longer lines"),
    surface<&SurfaceOptions::arc_price>("surface.arc_price",
                                        "chi squared that an arc has to save; higher: fewer circles"),
    surface<&SurfaceOptions::clutter_price>("surface.clutter_price", "of a point that nothing explains"),
    surface<&SurfaceOptions::attached_end_price>("surface.attached_end_price",
                                                 "of an arc's end where its surface goes on"),
    surface<&SurfaceOptions::unsure_arc_price>(
        "surface.unsure_arc_price", "what an arc with an end that is not free has to gain to be a circle"),
    surface<&SurfaceOptions::hidden_end_price>(
        "surface.hidden_end_price",
        "the same on top for each end at something nearer or at the edge of view"),
    surface<&SurfaceOptions::shallow_arc_price>("surface.shallow_arc_price",
                                                "the same on top where little of its round is in view"),
    surface<&SurfaceOptions::shallow_arc_rad>("surface.shallow_arc_rad", "less of a round in view is little"),
    surface<&SurfaceOptions::doubt_ratio>(
        "surface.doubt_ratio", "share of a perfect arc's gain that a circle needs; higher: fewer circles"),
    surface<&SurfaceOptions::doubt_start>("surface.doubt_start", "gain that is left out of that share"),
    surface<&SurfaceOptions::max_doubt>("surface.max_doubt", "a circle needs no more gain than this"),
    surface<&SurfaceOptions::max_chi2_per_point>("surface.max_chi2_per_point",
                                                 "lines and circles that fit worse are not reported"),
    surface<&SurfaceOptions::max_direction_sigma_rad>("surface.max_direction_sigma_rad",
                                                      "lines of a more uncertain direction are not reported"),
    surface<&SurfaceOptions::min_radius_m>("surface.min_radius_m", "thinner arcs are no circles"),
    surface<&SurfaceOptions::max_radius_m>("surface.max_radius_m", "thicker arcs are no circles"),

    interpret<&InterpretOptions::min_wall_m>("interpret.min_wall_m",
                                             "straight pieces that together are shorter are no wall"),
    interpret<&InterpretOptions::wall_offset_m>("interpret.wall_offset_m",
                                                "pieces of one wall lie so near to its line"),
    interpret<&InterpretOptions::max_wall_gap_m>("interpret.max_wall_gap_m",
                                                 "pieces of one wall are no farther apart"),
    interpret<&InterpretOptions::min_corner_rad>("interpret.min_corner_rad",
                                                 "between the walls of a corner, at least"),
    interpret<&InterpretOptions::corner_reach_m>("interpret.corner_reach_m",
                                                 "the walls of a corner end so near to it"),
    interpret<&InterpretOptions::min_door_m>("interpret.min_door_m", "narrower gaps in a wall are no doors"),
    interpret<&InterpretOptions::max_door_m>("interpret.max_door_m", "wider gaps in a wall are no doors"),
    interpret<&InterpretOptions::bench_gap_m>("interpret.bench_gap_m",
                                              "between the middles of a bench's feet"),
    interpret<&InterpretOptions::bench_tolerance_m>("interpret.bench_tolerance_m",
                                                    "by which that gap may be off"),
    interpret<&InterpretOptions::max_bench_radius_m>("interpret.max_bench_radius_m",
                                                     "thicker things are no feet of a bench"),
    interpret<&InterpretOptions::min_trash_can_radius_m>("interpret.min_trash_can_radius_m",
                                                         "thinner round things are columns"),
    interpret<&InterpretOptions::max_trash_can_radius_m>("interpret.max_trash_can_radius_m",
                                                         "thicker round things are columns"),

    row<&All::track, &TrackOptions::motion>(
        "track.motion",
        "where the sensor's own motion is taken from; odometry is taken for "
        "that of a laser at the robot's centre that looks ahead",
        kBoth, kMotionSourceWords),
    track<&TrackOptions::gate_m>("track.gate_m",
                                 "a feature farther from where a track is expected is not its own"),
    track<&TrackOptions::gate_speed_m_per_s>("track.gate_speed_m_per_s",
                                             "widens that gate by this times the time since the last hit"),
    track<&TrackOptions::max_gate_m>(
        "track.max_gate_m",
        "the gate grows no further, but for a person's stride and the way of hidden cylinders"),
    track<&TrackOptions::num_confirming_hits>("track.num_confirming_hits",
                                              "a track is reported from this hit on"),
    track<&TrackOptions::sure_score>("track.sure_score",
                                     "two legs at once with this score are reported from the first hit on"),
    track<&TrackOptions::num_coasted_scans>("track.num_coasted_scans",
                                            "a track is reported through so many scans without a hit"),
    track<&TrackOptions::max_hidden_s>("track.max_hidden_s",
                                       "behind something nearer a track is remembered so long"),
    track<&TrackOptions::max_lost_s>("track.max_lost_s",
                                     "a person who walked and was lost is known again for so long"),
    track<&TrackOptions::evidence_keep_ratio>("track.evidence_keep_ratio",
                                              "share of the mean log-odds that is kept from hit to hit"),
    track<&TrackOptions::displacement_window_s>("track.displacement_window_s",
                                                "net displacement over this time speaks for a person"),
    track<&TrackOptions::displacement_step_m>("track.displacement_step_m",
                                              "so much displacement adds 1 to the log-odds"),
    track<&TrackOptions::max_displacement_evidence>("track.max_displacement_evidence",
                                                    "displacement adds no more than this"),
    track<&TrackOptions::max_leg_distance_m>("track.max_leg_distance_m",
                                             "between two legs that are taken for a person's"),
    track<&TrackOptions::thin_circle_score>("track.thin_circle_score",
                                            "of a leg that was found as a thin circle alone; 0: it is none"),
    track<&TrackOptions::min_score>("track.min_score", "persons and legs below are not reported"),
    track<&TrackOptions::min_cylinder_radius_m>("track.min_cylinder_radius_m",
                                                "thinner circles are not followed"),
    track<&TrackOptions::max_cylinder_radius_m>("track.max_cylinder_radius_m",
                                                "thicker circles are not followed"),
    track<&TrackOptions::mobile_distance_m>(
        "track.mobile_distance_m", "a cylinder that moved so far within the window is mobile for good"),
};

struct Ending {
  std::string_view ending;
  std::string_view unit;
};

constexpr std::array<Ending, 4> kEndings = {{{"_m_per_s", "m/s"}, {"_rad", "rad"}, {"_m", "m"}, {"_s", "s"}}};

}  // namespace

void AnalysisOptions::validate() const {
  detector.validate();
  interpret.validate();
  track.validate();
}

std::string_view Option::group() const {
  const std::size_t dot = path.find('.');
  return dot == std::string_view::npos ? std::string_view() : path.substr(0, dot);
}

std::string_view Option::name() const {
  return path.substr(path.find('.') + 1);  // npos + 1 is 0: the whole of a path without a group
}

std::string_view Option::unit() const {
  for (const Ending& ending : kEndings) {
    if (path.ends_with(ending.ending)) return ending.unit;
  }
  return {};
}

std::string_view to_string(OptionReader reader) {
  switch (reader) {
    case OptionReader::kBoth:
      return "both pipelines";
    case OptionReader::kPaper:
      return "the paper pipeline";
    case OptionReader::kRobust:
      return "the robust pipeline";
    case OptionReader::kLegRules:
      return "leg.scorer: rules";
    case OptionReader::kSegments:
      return "the paper pipeline or leg.scorer: rules";
    case OptionReader::kInterpretation:
      return "the interpretation of scenes";
    case OptionReader::kTracking:
      return "tracking";
  }
  return "";
}

bool Option::is_read(const AnalysisOptions& options) const {
  const bool is_paper = options.detector.pipeline == Pipeline::kPaper;
  const bool has_rules = options.detector.leg.scorer == LegScorer::kRules;
  switch (reader) {
    case OptionReader::kBoth:
    case OptionReader::kInterpretation:
    case OptionReader::kTracking:
      return true;
    case OptionReader::kPaper:
      return is_paper;
    case OptionReader::kRobust:
      return !is_paper;
    case OptionReader::kLegRules:
      return has_rules;
    case OptionReader::kSegments:
      return is_paper || has_rules;
  }
  return true;
}

std::string Option::text(const AnalysisOptions& options) const {
  const double value = get(options);
  if (kind == OptionKind::kFlag) return value != 0.0 ? "true" : "false";
  if (kind == OptionKind::kChoice) return std::string(words[static_cast<std::size_t>(value)]);
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::span<const Option> option_table() {
  return kTable;
}

const Option* find_option(std::string_view path) {
  const auto found =
      std::find_if(kTable.begin(), kTable.end(), [&](const Option& o) { return o.path == path; });
  return found == kTable.end() ? nullptr : &*found;
}

}  // namespace scanbed
