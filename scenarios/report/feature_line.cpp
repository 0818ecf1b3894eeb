// SPDX-License-Identifier: MIT
#include "scenarios/report/feature_line.hpp"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "scenarios/report/append_format.hpp"

namespace scanbed::scenarios {
namespace {

// Written by hand rather than through a JSON tree: this is printed for every scan of a recording.
class ObjectWriter {
 public:
  explicit ObjectWriter(std::string& out) : out_(out) {}

  ObjectWriter& number(std::string_view key, double value) {
    begin(key);
    put(value);
    return *this;
  }
  ObjectWriter& number_or_null(std::string_view key, const std::optional<double>& value) {
    return number(key, value.value_or(std::nan("")));
  }
  ObjectWriter& count(std::string_view key, std::int64_t value) {
    begin(key);
    append_format(out_, "{}", value);
    return *this;
  }
  ObjectWriter& point(std::string_view key, const Eigen::Vector2d& p_m) {
    begin(key);
    out_ += '[';
    put(p_m.x());
    out_ += ',';
    put(p_m.y());
    out_ += ']';
    return *this;
  }
  /// Row by row; null where it is not known.
  template <typename Matrix>
  ObjectWriter& matrix_or_null(std::string_view key, const std::optional<Matrix>& value) {
    begin(key);
    if (!value) {
      out_ += "null";
      return *this;
    }
    char before = '[';
    for (const double element : value->template reshaped<Eigen::RowMajor>()) {
      append_format(out_, "{}{:.6g}", before, element);  // in digits that count: these may be millionths
      before = ',';
    }
    out_ += ']';
    return *this;
  }

 private:
  void begin(std::string_view key) { append_format(out_, ",\"{}\":", key); }

  void put(double value) {
    if (!std::isfinite(value)) {
      out_ += "null";
      return;
    }
    // Doubles from here on are whole, and would overflow at the end of their range.
    const bool is_whole = std::abs(value) > 0x1p53;
    const double rounded = is_whole ? value : std::round(value * 1e6) / 1e6;
    // Adding zero turns -0 into 0.
    append_format(out_, "{}", rounded + 0.0);
  }

  std::string& out_;
};

using AnyFeature = std::variant<const Line*, const Circle*, const Leg*>;

struct PlacedFeature {
  AnyFeature feature;
  FeatureRef ref;

  int first_beam() const {
    return std::visit([](const auto* f) { return f->beams.first; }, feature);
  }
};

std::vector<PlacedFeature> in_order(const Features& features) {
  std::vector<PlacedFeature> all;
  const auto add = [&all](const auto& list, Primitive kind) {
    for (const auto& feature : list)
      all.push_back({&feature, {kind, static_cast<int>(&feature - list.data())}});
  };
  add(features.lines, Primitive::kLine);
  add(features.circles, Primitive::kCircle);
  add(features.legs, Primitive::kLeg);
  std::stable_sort(all.begin(), all.end(), [](const PlacedFeature& a, const PlacedFeature& b) {
    return a.first_beam() < b.first_beam();
  });
  return all;
}

ObjectWriter begin_object(std::string& out, std::string_view type, const BeamSpan& beams) {
  append_format(out, R"({{"type":"{}","first":{},"last":{})", type, beams.first, beams.last);
  return ObjectWriter(out);
}

void append(std::string& out, const Line& line) {
  begin_object(out, "line", line.beams)
      .point("left", line.left_m)
      .point("right", line.right_m)
      .number_or_null("slope", line.slope)
      .number_or_null("bias", line.bias_m)
      .count("points", line.num_points)
      .number("error", line.error_m)
      .number("score", line.score)
      .matrix_or_null("covariance", line.covariance);
}

void append(std::string& out, const Circle& circle) {
  begin_object(out, "circle", circle.beams)
      .point("center", circle.center_m)
      .number("radius", circle.radius_m)
      .number_or_null("average", circle.average_rad)
      .number_or_null("std", circle.std_rad)
      .number("score", circle.score)
      .matrix_or_null("covariance", circle.covariance);
}

void append(std::string& out, const Leg& leg) {
  begin_object(out, "leg", leg.beams).point("middle", leg.middle_m).number("score", leg.score);
}

std::string_view name_of(TrackKind kind) {
  switch (kind) {
    case TrackKind::kPerson:
      return "person";
    case TrackKind::kCylinder:
      return "cylinder";
    case TrackKind::kLeg:
      break;
  }
  return "leg";
}

void append(std::string& out, const Track& track) {
  append_format(out, R"({{"id":{},"kind":"{}")", track.id, name_of(track.kind));
  ObjectWriter writer(out);
  writer.point("position", track.position_m).point("velocity", track.velocity_m_per_s);
  if (track.kind == TrackKind::kCylinder) writer.number("radius", track.radius_m);
  writer.number("score", track.score);
}

// What only some kinds have.
void append_details(std::string& out, const SceneObject& object) {
  ObjectWriter writer(out);
  switch (object.kind) {
    case SceneKind::kDoor:
      out += object.is_open ? ",\"open\":true" : ",\"open\":false";
      [[fallthrough]];
    case SceneKind::kWall:
      writer.point("left", object.left_m).point("right", object.right_m);
      break;
    case SceneKind::kCorner:
      out += object.is_outer ? ",\"corner\":\"outer\"" : ",\"corner\":\"inner\"";
      break;
    case SceneKind::kBench:
      writer.point("left", object.left_m).point("right", object.right_m);
      [[fallthrough]];
    case SceneKind::kColumn:
    case SceneKind::kTrashCan:
      writer.number("radius", object.radius_m);
      break;
  }
}

void append_scene(std::string& out, const Scene& scene, const std::vector<PlacedFeature>& features) {
  const auto place_of = [&features](const FeatureRef& ref) {
    const auto it =
        std::find_if(features.begin(), features.end(), [&](const auto& f) { return f.ref == ref; });
    return it - features.begin();
  };
  bool is_first = true;
  for (const SceneObject& object : scene.objects) {
    if (!is_first) out += ',';
    is_first = false;
    append_format(out, R"({{"kind":"{}")", to_string(object.kind));
    ObjectWriter(out).point("center", object.center_m);
    append_details(out, object);
    out += ",\"from\":[";
    for (const FeatureRef& ref : scene.from_of(object)) {
      if (out.back() != '[') out += ',';
      append_format(out, "{}", place_of(ref));
    }
    out += ']';
    ObjectWriter(out).number("score", object.score);
    out += '}';
  }
}

}  // namespace

void append_feature_line(std::string& out, const Findings& findings) {
  append_format(out, R"({{"scan":{})", findings.scan.index);
  ObjectWriter(out).number("t_s", findings.scan.time_s);
  const std::vector<PlacedFeature> features = in_order(findings.features);
  out += ",\"features\":[";
  for (const PlacedFeature& placed : features) {
    if (out.back() != '[') out += ',';
    std::visit([&out](const auto* f) { append(out, *f); }, placed.feature);
    out += '}';
  }
  out += ']';
  if (findings.tracks != nullptr) {
    out += ",\"tracks\":[";
    for (const Track& track : *findings.tracks) {
      if (out.back() != '[') out += ',';
      append(out, track);
      out += '}';
    }
    out += ']';
  }
  if (findings.scene != nullptr) {
    out += ",\"scene\":[";
    append_scene(out, *findings.scene, features);
    out += ']';
  }
  out += "}\n";
}

}  // namespace scanbed::scenarios
