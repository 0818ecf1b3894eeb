// SPDX-License-Identifier: MIT
#include "hw/recording/mcap_message.hpp"

#include <gtest/gtest.h>

#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

// The sample of the schema's description.
constexpr std::string_view kForeign =
    R"({"timestamp":{"sec":1700000000,"nsec":500000000},"frame_id":"laser","pose":{"position":{"x":0,"y":0,"z":0},)"
    R"("orientation":{"x":0,"y":0,"z":0,"w":1}},"start_angle":-1.5,"end_angle":1.5,"ranges":[2.0,0,2.09],)"
    R"("intensities":[]})";

TEST(McapMessageTest, ReadsALaserScanThatStandsAlone) {
  RecordedScan recorded_scan;
  decode_mcap_scan(kForeign, {}, recorded_scan);
  const LaserScan& scan = recorded_scan.scan;
  EXPECT_EQ(scan.range_m, (std::vector<double>{2.0, kNoEcho, 2.09}));
  EXPECT_EQ(scan.geometry.first_rad, -1.5);
  EXPECT_EQ(scan.geometry.step_rad, 1.5);
  EXPECT_EQ(scan.time_s, 1700000000.5);
  EXPECT_FALSE(scan.X_OR.has_value());
}

TEST(McapMessageTest, WithBeamsAScanIsWhatItWas) {
  LaserScan before = made_scan(3);
  before.geometry.timing = {.num_rotations = 2, .rotation_s = 1.0 / 75.0, .step_s = 1e-5};
  before.source = "left";
  const Features features = made_features();
  const Truth truth = made_truth(before.num_beams());
  RecordedScan after;
  decode_mcap_scan(encode_mcap_scan(before),
                   {.beams = encode_mcap_beams(before),
                    .features = encode_mcap_features(features, before.time_s),
                    .truth = encode_mcap_truth(truth, before.time_s)},
                   after);
  EXPECT_TRUE(same_ranges(after.scan, before));
  EXPECT_EQ(after.scan.geometry.timing.num_rotations, 2);
  EXPECT_EQ(after.scan.source, "left");
  EXPECT_EQ(after.scan.X_OR->p_m, before.X_OR->p_m);
  EXPECT_EQ(after.features->circles.size(), 2U);
  EXPECT_EQ(after.truth->objects.size(), 1U);
}

TEST(McapMessageTest, RefusesWhatDoesNotFit) {
  RecordedScan out;
  const LaserScan big = made_scan(1);
  EXPECT_THROW(decode_mcap_scan("{}", {}, out), InputError);
  EXPECT_THROW(decode_mcap_scan("", {}, out), InputError);
  // Beams, features and truth of a scan with more beams.
  EXPECT_THROW(decode_mcap_scan(kForeign, {.beams = encode_mcap_beams(big)}, out), InputError);
  EXPECT_THROW(decode_mcap_scan(kForeign, {.features = encode_mcap_features(made_features(), 0.0)}, out),
               InputError);
  EXPECT_THROW(decode_mcap_scan(kForeign, {.truth = encode_mcap_truth(made_truth(361), 0.0)}, out),
               InputError);
}

}  // namespace
}  // namespace scanbed::hw
