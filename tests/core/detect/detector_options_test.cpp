// SPDX-License-Identifier: MIT
#include "core/detect/detector_options.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "core/errors/input_error.hpp"

namespace scanbed {
namespace {

TEST(DetectorOptionsTest, ThePapersOptionsValidate) {
  EXPECT_NO_THROW(paper_options().validate());
}

TEST(DetectorOptionsTest, EachFieldOutOfRangeIsNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::pair<const char*, std::function<void(DetectorOptions&)>> cases[] = {
      {"segmentation.max_gap_m", [](auto& o) { o.segmentation.max_gap_m = 0.0; }},
      {"segmentation.max_gap_m", [nan](auto& o) { o.segmentation.max_gap_m = nan; }},
      {"segmentation.min_points", [](auto& o) { o.segmentation.min_points = 0; }},
      {"circle.max_std_rad", [](auto& o) { o.circle.max_std_rad = 0.5; }},
      {"circle.min_average_rad", [](auto& o) { o.circle.min_average_rad = 0.0; }},
      {"circle.max_average_rad", [](auto& o) { o.circle.max_average_rad = 1.0; }},
      {"circle.min_length_m", [](auto& o) { o.circle.min_length_m = -1.0; }},
      {"circle.max_length_m", [](auto& o) { o.circle.max_length_m = 0.1; }},
      {"circle.min_points", [](auto& o) { o.circle.min_points = 2; }},
      {"circle.min_depth_ratio", [](auto& o) { o.circle.min_depth_ratio = -0.1; }},
      {"circle.max_depth_ratio", [](auto& o) { o.circle.max_depth_ratio = 0.05; }},
      {"line.min_length_m", [](auto& o) { o.line.min_length_m = -1.0; }},
      {"line.min_points", [](auto& o) { o.line.min_points = 1; }},
      {"line.max_error_m", [](auto& o) { o.line.max_error_m = 0.0; }},
      {"line.max_average_deviation_rad", [](auto& o) { o.line.max_average_deviation_rad = 2.0; }},
      {"line.max_std_rad", [](auto& o) { o.line.max_std_rad = 0.0; }},
      {"pipeline", [](auto& o) { o.pipeline = static_cast<Pipeline>(99); }},
      {"circle.method", [](auto& o) { o.circle.method = static_cast<CircleMethod>(99); }},
      {"line.method", [](auto& o) { o.line.method = static_cast<LineMethod>(99); }},
      {"leg.scorer", [](auto& o) { o.leg.scorer = static_cast<LegScorer>(-1); }},
      {"leg.min_score", [](auto& o) { o.leg.min_score = 1.5; }},
      {"leg.min_doubtful_score", [](auto& o) { o.leg.min_doubtful_score = -0.1; }},
      {"leg.min_width_m", [](auto& o) { o.leg.min_width_m = 0.0; }},
      {"leg.max_width_m", [](auto& o) { o.leg.max_width_m = 0.05; }},
      {"leg.min_points", [](auto& o) { o.leg.min_points = 2; }},
      {"leg.min_depth_ratio", [](auto& o) { o.leg.min_depth_ratio = 1.5; }},
      {"leg.max_depth_ratio", [](auto& o) { o.leg.max_depth_ratio = 0.0; }},
  };
  for (const auto& [name, spoil] : cases) {
    DetectorOptions options = paper_options();
    spoil(options);
    try {
      options.validate();
      ADD_FAILURE() << name << " was accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(name, 0), 0u) << error.what();
    }
  }
}

}  // namespace
}  // namespace scanbed
