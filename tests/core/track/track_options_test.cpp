// SPDX-License-Identifier: MIT
#include "core/track/track_options.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "core/errors/input_error.hpp"

namespace scanbed {
namespace {

TEST(TrackOptionsTest, DefaultsValidate) {
  EXPECT_NO_THROW(TrackOptions{}.validate());
}

TEST(TrackOptionsTest, EachBadFieldIsNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::string, std::function<void(TrackOptions&)>>> faults = {
      {"track.motion", [](TrackOptions& o) { o.motion = static_cast<MotionSource>(4); }},
      {"track.gate_m", [](TrackOptions& o) { o.gate_m = 0.0; }},
      {"track.gate_speed_m_per_s", [](TrackOptions& o) { o.gate_speed_m_per_s = -1.0; }},
      {"track.max_gate_m", [](TrackOptions& o) { o.max_gate_m = 0.1; }},
      {"track.num_confirming_hits", [](TrackOptions& o) { o.num_confirming_hits = 0; }},
      {"track.sure_score", [](TrackOptions& o) { o.sure_score = 1.1; }},
      {"track.num_coasted_scans", [](TrackOptions& o) { o.num_coasted_scans = -1; }},
      {"track.max_hidden_s", [nan](TrackOptions& o) { o.max_hidden_s = nan; }},
      {"track.max_lost_s", [](TrackOptions& o) { o.max_lost_s = -1.0; }},
      {"track.evidence_keep_ratio", [](TrackOptions& o) { o.evidence_keep_ratio = 1.0; }},
      {"track.displacement_window_s", [](TrackOptions& o) { o.displacement_window_s = 0.0; }},
      {"track.displacement_step_m", [](TrackOptions& o) { o.displacement_step_m = 0.0; }},
      {"track.max_displacement_evidence", [](TrackOptions& o) { o.max_displacement_evidence = -1.0; }},
      {"track.max_leg_distance_m", [](TrackOptions& o) { o.max_leg_distance_m = 0.0; }},
      {"track.thin_circle_score", [](TrackOptions& o) { o.thin_circle_score = 1.1; }},
      {"track.min_score", [](TrackOptions& o) { o.min_score = 1.5; }},
      {"track.min_cylinder_radius_m", [](TrackOptions& o) { o.min_cylinder_radius_m = -0.1; }},
      {"track.max_cylinder_radius_m", [](TrackOptions& o) { o.max_cylinder_radius_m = 0.05; }},
      {"track.mobile_distance_m", [](TrackOptions& o) { o.mobile_distance_m = 0.0; }},
  };
  for (const auto& [name, spoil] : faults) {
    TrackOptions options;
    spoil(options);
    try {
      options.validate();
      FAIL() << name << " was accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(name + ":", 0), 0u) << error.what();
    }
  }
}

}  // namespace
}  // namespace scanbed
