// SPDX-License-Identifier: MIT
#include "scenarios/report/feature_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <variant>
#include <vector>

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
    fmt::format_to(std::back_inserter(out_), "{}", value);
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

 private:
  void begin(std::string_view key) { fmt::format_to(std::back_inserter(out_), ",\"{}\":", key); }

  void put(double value) {
    if (!std::isfinite(value)) {
      out_ += "null";
      return;
    }
    const double rounded = std::round(value * 1e6) / 1e6;
    // Adding zero turns -0 into 0.
    fmt::format_to(std::back_inserter(out_), "{}", rounded + 0.0);
  }

  std::string& out_;
};

using AnyFeature = std::variant<const Line*, const Circle*, const Leg*>;

int first_beam(const AnyFeature& feature) {
  return std::visit([](const auto* f) { return f->beams.first; }, feature);
}

std::vector<AnyFeature> in_order(const Features& features) {
  std::vector<AnyFeature> all;
  for (const Line& line : features.lines) all.emplace_back(&line);
  for (const Circle& circle : features.circles) all.emplace_back(&circle);
  for (const Leg& leg : features.legs) all.emplace_back(&leg);
  std::stable_sort(all.begin(), all.end(),
                   [](const AnyFeature& a, const AnyFeature& b) { return first_beam(a) < first_beam(b); });
  return all;
}

ObjectWriter begin_object(std::string& out, std::string_view type, const BeamSpan& beams) {
  fmt::format_to(std::back_inserter(out), R"({{"type":"{}","first":{},"last":{})", type, beams.first,
                 beams.last);
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
      .number("score", line.score);
}

void append(std::string& out, const Circle& circle) {
  begin_object(out, "circle", circle.beams)
      .point("center", circle.center_m)
      .number("radius", circle.radius_m)
      .number("average", circle.average_rad)
      .number("std", circle.std_rad)
      .number("score", circle.score);
}

void append(std::string& out, const Leg& leg) {
  begin_object(out, "leg", leg.beams).point("middle", leg.middle_m).number("score", leg.score);
}

}  // namespace

void append_feature_line(std::string& out, const LaserScan& scan, const Features& features) {
  fmt::format_to(std::back_inserter(out), R"({{"scan":{})", scan.index);
  ObjectWriter(out).number("t_s", scan.time_s);
  out += ",\"features\":[";
  bool is_first = true;
  for (const AnyFeature& feature : in_order(features)) {
    if (!is_first) out += ',';
    is_first = false;
    std::visit([&out](const auto* f) { append(out, *f); }, feature);
    out += '}';
  }
  out += "]}\n";
}

}  // namespace scanbed::scenarios
