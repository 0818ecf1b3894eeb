// SPDX-License-Identifier: MIT
#include "hw/recording/scan_json.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "core/errors/input_error.hpp"
#include "core/geometry/angles.hpp"
#include "hw/recording/nano_time.hpp"

namespace scanbed::hw {
namespace {

constexpr std::array<std::string_view, 4> kPrimitives = {"none", "line", "circle", "leg"};
constexpr std::array<std::string_view, 3> kVisibilities = {"resolvable", "marginal", "hidden"};

template <class Enum, std::size_t kSize>
Enum read_name(const JsonValue& json, std::string_view key,
               const std::array<std::string_view, kSize>& names) {
  const std::string& text = json.at(key).text(key);
  for (std::size_t i = 0; i < kSize; ++i) {
    if (names[i] == text) return static_cast<Enum>(i);
  }
  throw InputError("'" + std::string(key) + "' has an unknown value");
}

double number_at(const JsonValue& json, std::string_view key) {
  return json.at(key).number(key);
}

void write_point(JsonText& json, std::string_view key, const Eigen::Vector2d& p_m) {
  json.key(key).begin_array().number(p_m.x()).number(p_m.y()).end_array();
}

Eigen::Vector2d read_point(const JsonValue& json, std::string_view key) {
  const JsonValue::Array& items = json.at(key).array(key);
  if (items.size() != 2) throw InputError("'" + std::string(key) + "' is not [x, y]");
  return {items[0].number(key), items[1].number(key)};
}

// Row by row, in one list: viewers convert no lists of lists.
template <typename Matrix>
void write_matrix(JsonText& json, std::string_view key, const std::optional<Matrix>& matrix) {
  if (!matrix) return;
  json.key(key).begin_array();
  for (const double element : matrix->template reshaped<Eigen::RowMajor>()) json.number(element);
  json.end_array();
}

template <typename Matrix>
std::optional<Matrix> read_matrix(const JsonValue& json, std::string_view key) {
  const JsonValue* const value = json.find(key);
  if (value == nullptr) return std::nullopt;
  const JsonValue::Array& items = value->array(key);
  Matrix matrix;
  if (static_cast<Eigen::Index>(items.size()) != matrix.size()) {
    throw InputError("'" + std::string(key) + "' has " + std::to_string(items.size()) + " elements, not " +
                     std::to_string(matrix.size()));
  }
  auto elements = matrix.template reshaped<Eigen::RowMajor>();
  for (Eigen::Index i = 0; i < matrix.size(); ++i) elements[i] = items[i].number(key);
  return matrix;
}

void begin_feature(JsonText& json, std::string_view type, const BeamSpan& beams) {
  json.begin_object()
      .key("type")
      .text(type)
      .key("first")
      .integer(beams.first)
      .key("last")
      .integer(beams.last);
}

BeamSpan read_beams(const JsonValue& json, int num_beams) {
  const BeamSpan beams = {json.at("first").integer("first"), json.at("last").integer("last")};
  if (0 <= beams.first && beams.first <= beams.last && beams.last < num_beams) return beams;
  throw InputError("a feature's beams " + std::to_string(beams.first) + ".." + std::to_string(beams.last) +
                   " are not among the scan's " + std::to_string(num_beams));
}

Line read_line(const JsonValue& json, int num_beams) {
  Line line;
  line.beams = read_beams(json, num_beams);
  line.left_m = read_point(json, "left");
  line.right_m = read_point(json, "right");
  if (const JsonValue* const slope = json.find("slope")) {
    line.slope = slope->number("slope");
    line.bias_m = number_at(json, "bias");
  }
  line.num_points = json.at("points").integer("points");
  line.error_m = number_at(json, "error");
  line.score = number_at(json, "score");
  line.covariance = read_matrix<Eigen::Matrix2d>(json, "covariance");
  return line;
}

Circle read_circle(const JsonValue& json, int num_beams) {
  Circle circle{.beams = read_beams(json, num_beams),
                .center_m = read_point(json, "center"),
                .radius_m = number_at(json, "radius"),
                .score = number_at(json, "score"),
                .covariance = read_matrix<Eigen::Matrix3d>(json, "covariance")};
  if (json.find("average") != nullptr) {
    circle.average_rad = number_at(json, "average");
    circle.std_rad = number_at(json, "std");
  }
  return circle;
}

Leg read_leg(const JsonValue& json, int num_beams) {
  return {.beams = read_beams(json, num_beams),
          .middle_m = read_point(json, "middle"),
          .score = number_at(json, "score")};
}

void write_line(JsonText& json, const Line& line) {
  begin_feature(json, "line", line.beams);
  write_point(json, "left", line.left_m);
  write_point(json, "right", line.right_m);
  if (line.slope && line.bias_m) json.key("slope").number(*line.slope).key("bias").number(*line.bias_m);
  json.key("points").integer(line.num_points).key("error").number(line.error_m);
  json.key("score").number(line.score);
  write_matrix(json, "covariance", line.covariance);
  json.end_object();
}

void write_circle(JsonText& json, const Circle& circle) {
  begin_feature(json, "circle", circle.beams);
  write_point(json, "center", circle.center_m);
  json.key("radius").number(circle.radius_m);
  if (circle.average_rad && circle.std_rad) {
    json.key("average").number(*circle.average_rad).key("std").number(*circle.std_rad);
  }
  json.key("score").number(circle.score);
  write_matrix(json, "covariance", circle.covariance);
  json.end_object();
}

void write_beam(JsonText& json, const BeamTruth& beam) {
  json.begin_object().key("object").integer(beam.object);
  json.key("range").number(std::isfinite(beam.range_m) ? beam.range_m : -1.0);
  json.key("incidence").number(beam.incidence_rad).key("mixed").integer(beam.mixed ? 1 : 0).end_object();
}

BeamTruth read_beam(const JsonValue& json, int num_objects) {
  BeamTruth beam;
  beam.object = json.at("object").integer("object");
  if (beam.object < kNoObject || beam.object >= num_objects) {
    throw InputError("a beam's object " + std::to_string(beam.object) + " is not among the " +
                     std::to_string(num_objects) + " objects");
  }
  beam.range_m = number_at(json, "range");
  if (beam.range_m < 0.0) beam.range_m = kNoEcho;
  beam.incidence_rad = number_at(json, "incidence");
  beam.mixed = json.at("mixed").integer("mixed") != 0;
  return beam;
}

void write_object(JsonText& json, const ObjectTruth& object) {
  json.begin_object().key("id").text(object.id).key("label").text(object.label);
  json.key("primitive").text(kPrimitives[static_cast<std::size_t>(object.primitive)]);
  write_point(json, "center", object.center_m);
  json.key("radius").number(object.radius_m);
  write_point(json, "from", object.from_m);
  write_point(json, "to", object.to_m);
  json.key("clean_beams").integer(object.num_clean_beams);
  json.key("visibility").text(kVisibilities[static_cast<std::size_t>(object.visibility)]).end_object();
}

ObjectTruth read_object(const JsonValue& json) {
  return {.id = json.at("id").text("id"),
          .label = json.at("label").text("label"),
          .primitive = read_name<Primitive>(json, "primitive", kPrimitives),
          .center_m = read_point(json, "center"),
          .radius_m = number_at(json, "radius"),
          .from_m = read_point(json, "from"),
          .to_m = read_point(json, "to"),
          .num_clean_beams = json.at("clean_beams").integer("clean_beams"),
          .visibility = read_name<Visibility>(json, "visibility", kVisibilities)};
}

}  // namespace

double read_time(const JsonValue& scan) {
  const double time_s = number_at(scan, "t_s");
  if (!is_time(time_s)) throw InputError("'t_s' is more than 1e12 s away from 0");
  return time_s;
}

void write_geometry(JsonText& json, const ScanGeometry& geometry) {
  json.begin_object().key("first_rad").number(geometry.first_rad).key("step_rad").number(geometry.step_rad);
  json.key("min_range_m").number(geometry.min_range_m);
  if (std::isfinite(geometry.max_range_m)) json.key("max_range_m").number(geometry.max_range_m);
  json.key("rotations").integer(geometry.timing.num_rotations);
  json.key("rotation_s").number(geometry.timing.rotation_s);
  json.key("step_s").number(geometry.timing.step_s).end_object();
}

ScanGeometry read_geometry(const JsonValue& json, int num_beams) {
  ScanGeometry geometry;
  geometry.num_beams = num_beams;
  geometry.first_rad = number_at(json, "first_rad");
  geometry.step_rad = number_at(json, "step_rad");
  geometry.min_range_m = number_at(json, "min_range_m");
  const JsonValue* const max_range = json.find("max_range_m");
  geometry.max_range_m =
      max_range == nullptr ? std::numeric_limits<double>::infinity() : max_range->number("max_range_m");
  geometry.timing.num_rotations = json.at("rotations").integer("rotations");
  geometry.timing.rotation_s = number_at(json, "rotation_s");
  geometry.timing.step_s = number_at(json, "step_s");
  check_geometry(geometry);
  return geometry;
}

void write_pose(JsonText& json, const Pose2& pose) {
  json.begin_array().number(pose.p_m.x()).number(pose.p_m.y()).number(pose.theta_rad).end_array();
}

Pose2 read_pose(const JsonValue& json) {
  const JsonValue::Array& items = json.array("a pose");
  if (items.size() != 3) throw InputError("a pose is not [x, y, theta]");
  return {{items[0].number("x"), items[1].number("y")}, wrap_to_pi(items[2].number("theta"))};
}

void write_health(JsonText& json, const SensorHealth& health) {
  if (health == SensorHealth{}) return;
  json.key("health").begin_object().key("severity").integer(health.severity);
  json.key("polluted").integer(health.is_polluted ? 1 : 0);
  json.key("implausible").integer(health.is_implausible ? 1 : 0).end_object();
}

SensorHealth read_health(const JsonValue& scan) {
  const JsonValue* const json = scan.find("health");
  if (json == nullptr) return {};
  return {.severity = json->at("severity").integer("severity"),
          .is_polluted = json->at("polluted").integer("polluted") != 0,
          .is_implausible = json->at("implausible").integer("implausible") != 0};
}

void write_features(JsonText& json, const Features& features) {
  json.begin_array();
  for (const Line& line : features.lines) write_line(json, line);
  for (const Circle& circle : features.circles) write_circle(json, circle);
  for (const Leg& leg : features.legs) {
    begin_feature(json, "leg", leg.beams);
    write_point(json, "middle", leg.middle_m);
    json.key("score").number(leg.score).end_object();
  }
  json.end_array();
}

Features read_features(const JsonValue& json, int num_beams) {
  Features features;
  for (const JsonValue& item : json.array("features")) {
    const std::string& type = item.at("type").text("type");
    if (type == "line") {
      features.lines.push_back(read_line(item, num_beams));
    } else if (type == "circle") {
      features.circles.push_back(read_circle(item, num_beams));
    } else if (type == "leg") {
      features.legs.push_back(read_leg(item, num_beams));
    }  // A later version may have further types.
  }
  return features;
}

void write_truth(JsonText& json, const Truth& truth) {
  json.begin_object().key("pose");
  write_pose(json, truth.X_WS);
  json.key("beams").begin_array();
  for (const BeamTruth& beam : truth.beams) write_beam(json, beam);
  json.end_array().key("objects").begin_array();
  for (const ObjectTruth& object : truth.objects) write_object(json, object);
  json.end_array().end_object();
}

Truth read_truth(const JsonValue& json, int num_beams) {
  Truth truth;
  truth.X_WS = read_pose(json.at("pose"));
  for (const JsonValue& item : json.at("objects").array("objects"))
    truth.objects.push_back(read_object(item));
  for (const JsonValue& item : json.at("beams").array("beams")) {
    truth.beams.push_back(read_beam(item, static_cast<int>(truth.objects.size())));
  }
  if (static_cast<int>(truth.beams.size()) == num_beams) return truth;
  throw InputError("the truth has " + std::to_string(truth.beams.size()) + " beams, but the scan " +
                   std::to_string(num_beams));
}

}  // namespace scanbed::hw
