// SPDX-License-Identifier: MIT
#include "hw/recording/ros_messages.hpp"

#include <gtest/gtest.h>

#include "tests/hw/recording/made_recording.hpp"

namespace scanbed::hw {
namespace {

// The message of the format's description, byte by byte: seq 0, stamp 1 s, frame "l", ranges 1, 2, inf.
std::string described_message() {
  return std::string(
      "\0\0\0\0\x01\0\0\0\0\0\0\0\x01\0\0\0l"
      "\0\0\x80\xbf\0\0\x80\x3f\0\0\x80\x3f\0\0\0\0\xcd\xcc\xcc\x3d\xcd\xcc\xcc\x3d\0\0\0\x41"
      "\x03\0\0\0\0\0\x80\x3f\0\0\0\x40\0\0\x80\x7f\0\0\0\0",
      65);
}

TEST(RosMessagesTest, ReadsTheMessageOfTheFormatsDescription) {
  LaserScan scan;
  decode_laser_scan(described_message(), scan);
  EXPECT_EQ(scan.time_s, 1.0);
  EXPECT_EQ(scan.geometry.first_rad, -1.0);
  EXPECT_EQ(scan.geometry.step_rad, 1.0);
  EXPECT_EQ(scan.geometry.min_range_m, 0.1);
  EXPECT_EQ(scan.geometry.max_range_m, 8.0);
  EXPECT_EQ(scan.geometry.timing.rotation_s, 0.1);
  EXPECT_EQ(scan.range_m, (std::vector<double>{1.0, 2.0, kNoEcho}));
}

TEST(RosMessagesTest, RefusesAnyOtherLength) {
  const std::string message = described_message();
  LaserScan scan;
  for (std::size_t size = 0; size < message.size(); ++size) {
    EXPECT_THROW(decode_laser_scan(message.substr(0, size), scan), InputError) << size;
  }
  EXPECT_THROW(decode_laser_scan(message + '\0', scan), InputError);
  std::string many = message;
  many.replace(45, 4, "\xff\xff\xff\xff");  // four billion ranges
  EXPECT_THROW(decode_laser_scan(many, scan), InputError);
}

TEST(RosMessagesTest, RangesOutsideOfTheLimitsAreNone) {
  LaserScan scan = made_scan(0);
  scan.geometry.min_range_m = 1.5;
  scan.geometry.max_range_m = 3.0;
  scan.range_m = {1.4, 1.5, 3.0, 3.1};
  LaserScan read;
  decode_laser_scan(encode_laser_scan(scan, 0), read);
  EXPECT_EQ(read.range_m, (std::vector<double>{kTooClose, 1.5, 3.0, kNoEcho}));
}

TEST(RosMessagesTest, OdometryComesBack) {
  const auto pose = decode_odometry(encode_odometry({{1.5, -2.0}, -3.0}, 7.0));
  ASSERT_TRUE(pose.has_value());
  EXPECT_EQ(pose->p_m, Eigen::Vector2d(1.5, -2.0));
  EXPECT_NEAR(pose->theta_rad, -3.0, 1e-15);
}

// "odom" and "base_link" as "/odom" and "/base_link"; lengths stand before them.
std::string with_slashes(std::string message) {
  for (const std::string frame : {"odom", "base_link"}) {
    const std::size_t at = message.find(frame);
    ++message[at - 4];
    message.insert(at, "/");
  }
  return message;
}

TEST(RosMessagesTest, OtherTransformsAreNoOdometry) {
  std::string message = encode_odometry({{1.0, 2.0}, 0.0}, 7.0);
  EXPECT_TRUE(decode_odometry(with_slashes(message)).has_value());  // as older versions of ROS name frames
  message[message.find("odom")] = 'x';
  EXPECT_FALSE(decode_odometry(message).has_value());
  EXPECT_FALSE(decode_odometry("").has_value());
  EXPECT_FALSE(decode_odometry("\xff\xff\xff\xff").has_value());
}

}  // namespace
}  // namespace scanbed::hw
