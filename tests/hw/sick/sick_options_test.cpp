// SPDX-License-Identifier: MIT
#include "hw/sick/sick_options.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "core/errors/input_error.hpp"

namespace scanbed::hw {
namespace {

std::string refusal(const std::function<void(SickOptions&)>& change) {
  SickOptions options;
  options.path = "/dev/ttyS0";
  change(options);
  try {
    options.validate();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SickOptionsTest, DefaultsWithAPortValidate) {
  EXPECT_EQ(refusal([](SickOptions&) {}), "");
}

TEST(SickOptionsTest, NamesTheFieldThatIsWrong) {
  EXPECT_NE(refusal([](SickOptions& o) { o.path = ""; }).find("no port"), std::string::npos);
  EXPECT_NE(refusal([](SickOptions& o) { o.baud = 115200; }).find("sick.baud"), std::string::npos);
  EXPECT_NE(refusal([](SickOptions& o) { o.fov_deg = 90; }).find("sick.fov_deg"), std::string::npos);
  EXPECT_NE(refusal([](SickOptions& o) { o.resolution_cdeg = 30; }).find("sick.resolution_deg"),
            std::string::npos);
  EXPECT_NE(refusal([](SickOptions& o) { o.measuring_mode = 0x3F; }).find("sick.mode"), std::string::npos);
  EXPECT_NE(refusal([](SickOptions& o) { o.measuring_mode = 256; }).find("sick.mode: value 256"),
            std::string::npos);
  EXPECT_NE(refusal([](SickOptions& o) { o.max_waiting = 0; }).find("sick.max_waiting"), std::string::npos);
}

TEST(SickOptionsTest, GeometryIsThatOfTheBeams) {
  const ScanGeometry geometry = sick_geometry({}, {});
  EXPECT_EQ(geometry.num_beams, 361);
  EXPECT_DOUBLE_EQ(geometry.bearing_rad(0), -kPi / 2);
  EXPECT_NEAR(geometry.bearing_rad(360), kPi / 2, 1e-12);
  EXPECT_EQ(geometry.max_range_m, 8.182);
  SickOptions narrow;
  narrow.fov_deg = 100;
  narrow.resolution_cdeg = 25;
  EXPECT_NEAR(sick_geometry(narrow, {}).bearing_rad(400), radians(50.0), 1e-12);
}

// Odd beams of a scan of half a degree come one turn of 13.32 ms after the even ones.
TEST(SickOptionsTest, BeamsHaveTheTimeOfTheirTurn) {
  const BeamTiming timing = sick_geometry({}, {}).timing;
  EXPECT_NEAR(timing.offset_s(1), 0.01332, 1e-12);
  EXPECT_NEAR(timing.offset_s(2), 0.01332 / 360.0, 1e-12);
  EXPECT_NEAR(timing.offset_s(360), 0.01332 / 2.0, 1e-12);
}

TEST(SickOptionsTest, AQuarterDegreeAt180IsPutTogetherHere) {
  SickOptions options;
  options.resolution_cdeg = 25;
  EXPECT_TRUE(options.is_interlaced_here());
  options.fov_deg = 100;
  EXPECT_FALSE(options.is_interlaced_here());
}

}  // namespace
}  // namespace scanbed::hw
