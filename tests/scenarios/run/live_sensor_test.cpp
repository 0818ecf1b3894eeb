// SPDX-License-Identifier: MIT
#include "scenarios/run/live_sensor.hpp"

#include <gtest/gtest.h>

#include "core/errors/sensor_fault.hpp"
#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

/// Times out a number of times before each scan; scan i has one beam of i metres.
class SlowDevice final : public RangeSensor {
 public:
  explicit SlowDevice(int num_timeouts) : num_timeouts_(num_timeouts) {}
  std::vector<SensorHealth> health;  // of the first scans
  int num_dropped = 0;               // between one scan and the next
  const ScanGeometry& geometry() const override { return geometry_; }
  bool next(LaserScan& scan, Seconds /*timeout*/) override {
    if (num_left_-- > 0) throw SensorFault(SensorFault::Kind::kTimeout, "not yet");
    num_left_ = num_timeouts_;
    scan.health = num_scans_ < static_cast<int>(health.size()) ? health[num_scans_] : SensorHealth{};
    scan.time_s = 7.5 + num_scans_;
    scan.index = num_scans_ * (num_dropped + 1);
    scan.range_m = {static_cast<double>(num_scans_++)};
    return true;
  }

 private:
  ScanGeometry geometry_;
  int num_timeouts_;
  int num_left_ = 2;
  int num_scans_ = 0;
};

class LostDevice final : public RangeSensor {
 public:
  const ScanGeometry& geometry() const override { return geometry_; }
  bool next(LaserScan& /*scan*/, Seconds /*timeout*/) override {
    throw SensorFault(SensorFault::Kind::kDisconnected, "gone");
  }

 private:
  ScanGeometry geometry_;
};

TEST(LiveSensorTest, WaitsThroughTimeouts) {
  LiveSensor sensor(std::make_unique<SlowDevice>(3), {});
  LaserScan scan;
  EXPECT_TRUE(sensor.next(scan, {}));
  EXPECT_TRUE(sensor.next(scan, {}));
  EXPECT_EQ(scan.range_m[0], 1.0);
}

TEST(LiveSensorTest, RunsOutOfPatience) {
  LiveSensor sensor(std::make_unique<SlowDevice>(3), {.patience_s = 0.0});
  LaserScan scan;
  EXPECT_THROW(sensor.next(scan, {}), SensorFault);
}

TEST(LiveSensorTest, TellsOnceThatScansStayAway) {
  std::vector<std::string> told;
  LiveSensor sensor(std::make_unique<SlowDevice>(3),
                    {.quiet_s = 0.0, .warn = [&](const std::string& line) { told.push_back(line); }});
  LaserScan scan;
  EXPECT_TRUE(sensor.next(scan, {}));
  EXPECT_EQ(told, std::vector<std::string>{"not yet"});
  EXPECT_TRUE(sensor.next(scan, {}));
  EXPECT_EQ(told.size(), 2U);
}

TEST(LiveSensorTest, TellsEverMoreSeldomThatScansWereDropped) {
  auto device = std::make_unique<SlowDevice>(0);
  device->num_dropped = 4;
  std::vector<std::string> told;
  LiveSensor sensor(std::move(device), {.warn = [&](const std::string& line) { told.push_back(line); }});
  LaserScan scan;
  for (int i = 0; i < 27; ++i) ASSERT_TRUE(sensor.next(scan, {}));
  EXPECT_EQ(told, (std::vector<std::string>{"scans come faster than they are taken: 4 dropped so far",
                                            "scans come faster than they are taken: 12 dropped so far",
                                            "scans come faster than they are taken: 100 dropped so far"}));
}

TEST(LiveSensorTest, PassesOtherFaultsOn) {
  LiveSensor sensor(std::make_unique<LostDevice>(), {});
  LaserScan scan;
  EXPECT_THROW(sensor.next(scan, {}), SensorFault);
}

TEST(LiveSensorTest, EndsAfterItsLimit) {
  LiveSensor sensor(std::make_unique<SlowDevice>(0), {.limit = 2});
  LaserScan scan;
  EXPECT_TRUE(sensor.next(scan, {}));
  EXPECT_TRUE(sensor.next(scan, {}));
  EXPECT_FALSE(sensor.next(scan, {}));
}

TEST(LiveSensorTest, CountsTimeFromTheFirstScanWhereItIsToldTo) {
  for (const bool from_zero : {false, true}) {
    LiveSensor sensor(std::make_unique<SlowDevice>(0), {.from_zero = from_zero});
    LaserScan scan;
    for (int i = 0; i < 3; ++i) {
      ASSERT_TRUE(sensor.next(scan, {}));
      EXPECT_EQ(scan.time_s, i + (from_zero ? 0.0 : 7.5));
    }
  }
}

TEST(LiveSensorTest, EndsWhereTheUserWantsItTo) {
  LiveSensor sensor(std::make_unique<SlowDevice>(1000), {.is_interrupted = [] { return true; }});
  LaserScan scan;
  EXPECT_FALSE(sensor.next(scan, {}));
}

TEST(LiveSensorTest, TellsOnceWhatTheDeviceSaysOfItsState) {
  auto device = std::make_unique<SlowDevice>(0);
  const SensorHealth dirty{.severity = 2, .is_polluted = true};
  const SensorHealth doubtful{.severity = 3, .is_polluted = true, .is_implausible = true};
  device->health = {{}, dirty, dirty, doubtful, {}};
  std::vector<std::string> told;
  LiveSensor sensor(std::move(device), {.warn = [&](const std::string& line) { told.push_back(line); }});
  LaserScan scan;
  for (int i = 0; i < 6; ++i) ASSERT_TRUE(sensor.next(scan, {}));
  EXPECT_EQ(told, (std::vector<std::string>{
                      "the laser reports a warning: its window is dirty",
                      "the laser reports an error: its window is dirty and its values are doubtful",
                      "the laser reports no trouble"}));
}

TEST(LiveSensorTest, JoinsScansWithTheirTruth) {
  testing::TemporaryFolder folder;
  TruthWriter writer(folder / "truth");
  writer.begin();
  Truth truth;
  truth.beams.resize(1);
  truth.X_WS.theta_rad = 0.5;
  writer.write(1, std::vector<double>{1.0}, truth);
  LiveSensor sensor(std::make_unique<SlowDevice>(0), {.truth = folder / "truth"});
  LaserScan scan;
  ASSERT_TRUE(sensor.next(scan, {}));
  EXPECT_EQ(sensor.truth(), nullptr);
  ASSERT_TRUE(sensor.next(scan, {}));
  ASSERT_NE(sensor.truth(), nullptr);
  EXPECT_EQ(sensor.truth()->X_WS.theta_rad, 0.5);
}

}  // namespace
}  // namespace scanbed::scenarios
