// SPDX-License-Identifier: MIT
#include "scenarios/run/analyst.hpp"

#include <gtest/gtest.h>

namespace scanbed::scenarios {
namespace {

LaserScan flat_wall() {
  LaserScan scan;
  for (int beam = 0; beam < scan.geometry.num_beams; ++beam) {
    const double cosine = std::cos(scan.geometry.bearing_rad(beam));
    scan.range_m.push_back(cosine > 0.3 ? 2.0 / cosine : kNoEcho);
  }
  return scan;
}

TEST(AnalystTest, SaysOnlyWhatWasAskedFor) {
  FeatureDetector detector(robust_options());
  const LaserScan scan = flat_wall();
  Analyst detects(detector, {});
  EXPECT_EQ(detects.analyse(scan).tracks, nullptr);
  EXPECT_EQ(detects.analyse(scan).scene, nullptr);
  EXPECT_EQ(detects.analyse(scan).features.lines.size(), 1u);
  Analyst tracks(detector, {.track = true});
  EXPECT_NE(tracks.analyse(scan).tracks, nullptr);
  EXPECT_EQ(tracks.analyse(scan).scene, nullptr);
  Analyst interprets(detector, {.interpret = true});
  EXPECT_EQ(interprets.analyse(scan).tracks, nullptr);
  const Findings findings = interprets.analyse(scan);
  ASSERT_NE(findings.scene, nullptr);
  ASSERT_EQ(findings.scene->objects.size(), 1u);
  EXPECT_EQ(findings.scene->objects[0].kind, SceneKind::kWall);
}

}  // namespace
}  // namespace scanbed::scenarios
