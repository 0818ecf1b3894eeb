// SPDX-License-Identifier: MIT
#include "core/detect/leg/leg_beams.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/scan_of.hpp"

namespace scanbed {
namespace {

using testing::scan_of;

TEST(LegBeamsTest, WhatIsNoDistanceIsNoEcho) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const LaserScan scan = scan_of({kNoEcho, 2.0, kTooClose, nan, 0.0, -1.0, 3.0, 1e9});
  LegBeams beams;
  LegBeamReader().read(scan, beams);
  EXPECT_EQ(beams.num_beams, 8);
  EXPECT_EQ(beams.beam, (std::vector<int>{1, 6}));
  EXPECT_EQ(beams.echo_range_m, (std::vector<double>{2.0, 3.0}));
  for (const int beam : {0, 2, 3, 4, 5, 7}) EXPECT_EQ(beams.range_m[beam], LegBeams::kNothing_m);
}

TEST(LegBeamsTest, EchoesLieWhereTheirBeamsPoint) {
  const LaserScan scan = scan_of({2.0, kNoEcho, 3.0});
  LegBeams beams;
  LegBeamReader().read(scan, beams);
  for (int k = 0; k < 2; ++k) {
    const double bearing_rad = scan.geometry.bearing_rad(beams.beam[k]);
    EXPECT_NEAR(beams.echo_x_m[k], beams.echo_range_m[k] * std::cos(bearing_rad), 1e-12);
    EXPECT_NEAR(beams.echo_y_m[k], beams.echo_range_m[k] * std::sin(bearing_rad), 1e-12);
    EXPECT_FLOAT_EQ(beams.x_m[beams.beam[k]], static_cast<float>(beams.echo_x_m[k]));
    EXPECT_FLOAT_EQ(beams.y_m[beams.beam[k]], static_cast<float>(beams.echo_y_m[k]));
  }
}

TEST(LegBeamsTest, AllInstructionSetsReadTheSameToTheBit) {
  const double others[] = {kNoEcho, 0.0, kInvalid, kTooClose, -1.0, 101.0, 1e300};
  std::vector<double> range_m(50);
  for (int i = 0; i < 50; ++i) range_m[i] = i % 5 == 2 ? others[i % 7] : 0.1 + 0.37 * i;
  for (; !range_m.empty(); range_m.pop_back()) {
    LegBeams plain;
    LegBeams widest;
    LegBeamReader(InstructionSet::kPlain).read(scan_of(range_m), plain);
    LegBeamReader().read(scan_of(range_m), widest);
    EXPECT_EQ(plain.range_m, widest.range_m);
    EXPECT_EQ(plain.x_m, widest.x_m);
    EXPECT_EQ(plain.y_m, widest.y_m);
    EXPECT_EQ(plain.beam, widest.beam);
    EXPECT_EQ(plain.echo_range_m, widest.echo_range_m);
    EXPECT_EQ(plain.echo_x_m, widest.echo_x_m);
    EXPECT_EQ(plain.echo_y_m, widest.echo_y_m);
  }
}

TEST(LegBeamsTest, WholeBlocksCanBeReadFromEveryBeam) {
  for (const int num_beams : {0, 1, 7, 8, 9, 361}) {
    LegBeams beams;
    LegBeamReader().read(scan_of(std::vector<double>(num_beams, 2.0)), beams);
    for (const auto* values : {&beams.range_m, &beams.x_m, &beams.y_m}) {
      EXPECT_GE(static_cast<int>(values->size()), num_beams + LegBeamReader::kBlock - 1);
    }
    EXPECT_EQ(beams.range_m.back(), LegBeams::kNothing_m);
  }
}

TEST(LegBeamsTest, AGeometryWithoutStepsIsNotDividedBy) {
  LaserScan scan = scan_of({2.0, 2.0});
  scan.geometry.step_rad = 0.0;
  LegBeams beams;
  LegBeamReader().read(scan, beams);
  EXPECT_GT(beams.step_rad, 0.0);
}

}  // namespace
}  // namespace scanbed
