// SPDX-License-Identifier: MIT
#include "hw/recording/scan_json.hpp"

#include <gtest/gtest.h>

#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

template <class Write>
JsonValue written(const Write& write) {
  std::string out;
  JsonText json(out);
  write(json);
  return parse_json(out);
}

TEST(ScanJsonTest, GeometryComesBack) {
  ScanGeometry geometry{.num_beams = 7, .first_rad = -1.0 / 3.0, .step_rad = 0.1, .min_range_m = 0.02};
  geometry.timing = {.num_rotations = 2, .rotation_s = 1.0 / 75.0, .step_s = 1e-5};
  for (const double max_range_m : {8.182, HUGE_VAL}) {
    geometry.max_range_m = max_range_m;
    const ScanGeometry read =
        read_geometry(written([&](JsonText& json) { write_geometry(json, geometry); }), 7);
    EXPECT_EQ(read, geometry);
    EXPECT_EQ(read.max_range_m, max_range_m);
    EXPECT_EQ(read.min_range_m, 0.02);
    EXPECT_EQ(read.timing.num_rotations, 2);
    EXPECT_EQ(read.timing.step_s, 1e-5);
  }
}

TEST(ScanJsonTest, FeaturesComeBack) {
  const Features features = made_features();
  const Features read = read_features(written([&](JsonText& json) { write_features(json, features); }), 361);
  ASSERT_EQ(read.lines.size(), 2U);
  EXPECT_EQ(read.lines[0].beams.last, 40);
  EXPECT_EQ(read.lines[0].left_m, features.lines[0].left_m);
  EXPECT_EQ(read.lines[0].slope, features.lines[0].slope);
  EXPECT_EQ(read.lines[0].bias_m, features.lines[0].bias_m);
  EXPECT_EQ(read.lines[0].num_points, 41);
  EXPECT_FALSE(read.lines[1].slope.has_value());
  EXPECT_EQ(read.lines[0].covariance, features.lines[0].covariance);
  EXPECT_FALSE(read.lines[1].covariance.has_value());
  ASSERT_EQ(read.circles.size(), 2U);
  EXPECT_EQ(read.circles[0].center_m, features.circles[0].center_m);
  EXPECT_EQ(read.circles[0].average_rad, 1.9);
  EXPECT_EQ(read.circles[0].std_rad, 0.25);
  EXPECT_FALSE(read.circles[1].average_rad || read.circles[1].std_rad);
  EXPECT_FALSE(read.circles[0].covariance.has_value());
  EXPECT_EQ(read.circles[1].covariance, features.circles[1].covariance);
  ASSERT_EQ(read.legs.size(), 1U);
  EXPECT_EQ(read.legs[0].score, 0.8);
}

TEST(ScanJsonTest, RefusesACovarianceOfAnotherSize) {
  for (const char* const matrix : {"[1,2]", "[1,2,3]", "[[1,2],[3,4]]", "[1,2,3,4,5,6,7,8,9]", "1"}) {
    const std::string text = R"([{"type":"line","first":0,"last":9,"left":[0,1],"right":[1,1],"points":10,)"
                             R"("error":0,"score":1,"covariance":)" +
                             std::string(matrix) + "}]";
    EXPECT_THROW(read_features(parse_json(text), 361), InputError) << matrix;
  }
}

TEST(ScanJsonTest, TruthComesBack) {
  const Truth truth = made_truth(361);
  const Truth read = read_truth(written([&](JsonText& json) { write_truth(json, truth); }), 361);
  EXPECT_EQ(read.X_WS.p_m, truth.X_WS.p_m);
  EXPECT_EQ(read.beams[3].object, 0);
  EXPECT_TRUE(read.beams[3].mixed);
  EXPECT_EQ(read.beams[3].range_m, 2.0 / 3.0);
  EXPECT_EQ(read.beams[4].object, kNoObject);
  EXPECT_EQ(read.beams[4].range_m, kNoEcho);
  ASSERT_EQ(read.objects.size(), 1U);
  EXPECT_EQ(read.objects[0].primitive, Primitive::kCircle);
  EXPECT_EQ(read.objects[0].visibility, Visibility::kResolvable);
  EXPECT_EQ(read.objects[0].num_clean_beams, 19);
}

TEST(ScanJsonTest, RefusesTruthThatDoesNotFit) {
  const JsonValue json = written([](JsonText& out) { write_truth(out, made_truth(361)); });
  EXPECT_THROW(read_truth(json, 360), InputError);
  Truth wrong = made_truth(5);
  wrong.beams[0].object = 1;
  EXPECT_THROW(read_truth(written([&](JsonText& out) { write_truth(out, wrong); }), 5), InputError);
  EXPECT_THROW(read_truth(parse_json("{}"), 0), InputError);
  EXPECT_THROW(read_pose(parse_json("[1,2]")), InputError);
}

}  // namespace
}  // namespace scanbed::hw
