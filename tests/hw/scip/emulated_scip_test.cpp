// SPDX-License-Identifier: MIT
#include "hw/scip/emulated_scip.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hw/scip/scip_text.hpp"
#include "tests/support/wide_sensor.hpp"

namespace scanbed::hw {
namespace {

/// An emulated sensor in a time of its own.
class EmulatedScipTest : public ::testing::Test {
 protected:
  std::string ask(const std::string& text) {
    lms_.receive({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, now_s_);
    return run();
  }
  std::string run() {
    Bytes out;
    lms_.run(now_s_, out);
    return {out.begin(), out.end()};
  }

  tests::WideSensor source_;
  EmulatedScip lms_{{}, source_};
  double now_s_ = 50.0;
};

TEST_F(EmulatedScipTest, AnswersAsSpecified) {
  EXPECT_EQ(ask("QT\n"), "QT\n00P\n\n");
  EXPECT_EQ(ask("BM\r\n"), "BM\n00P\n\n");
  EXPECT_EQ(ask("BM\n"), "BM\n02R\n\n");
  EXPECT_EQ(ask("XX\n"), "XX\n0Ee\n\n");
  EXPECT_EQ(ask("SCIP2.0\n"), "SCIP2.0\n0Ee\n\n");
  EXPECT_EQ(ask("PP\n"), "PP\n00P\n" + to_scip_info(utm_30lx()) + "\n");
  EXPECT_EQ(ask("%ST\n").substr(0, 8), "%ST\n00P\n");
}

TEST_F(EmulatedScipTest, NoScanWithoutLaser) {
  EXPECT_EQ(ask("GD0000108001\n"), "GD0000108001\n10Q\n\n");
  EXPECT_EQ(ask("MD0000200001000\n"), "MD0000200001000\n04T\n\n");
  EXPECT_EQ(ask("MD0100000001000\n"), "MD0100000001000\n05U\n\n");
  EXPECT_EQ(ask("MD\n"), "MD\n0Cc\n\n");
}

TEST_F(EmulatedScipTest, GivesAScanOfItsSource) {
  ask("QT\n");
  ask("BM\n");
  now_s_ += 1.0;
  // Step 0 points to -135 degrees, beam 180 of the source: 1180 mm.
  const std::string expected = encode_scip(1180, 3) + encode_scip(1181, 3) + encode_scip(1182, 3);
  EXPECT_EQ(ask("GD0000000201\n"), "GD0000000201\n00P\n00?Xg\n" + to_scip_blocks(expected) + "\n");
  // Two steps grouped are the nearer of them.
  const std::string grouped = encode_scip(1181, 3) + encode_scip(1183, 3);
  EXPECT_EQ(ask("GD0000000302\n"), "GD0000000302\n00P\n00?Xg\n" + to_scip_blocks(grouped) + "\n");
}

TEST_F(EmulatedScipTest, AFiniteStreamCountsDown) {
  EXPECT_EQ(ask("MD0000000001002\n"), "MD0000000001002\n00P\n\n");
  // Steps 0 to 1080 of 1440 of a turn of 25 ms; the stamp is of step 0.
  now_s_ += 0.018;
  EXPECT_EQ(run(), "");
  now_s_ += 0.001;
  EXPECT_TRUE(run().starts_with("MD0000000001001\n99b\n00000\n"));
  now_s_ += 0.03;
  EXPECT_TRUE(run().starts_with("MD0000000001000\n99b\n"));
  now_s_ += 0.03;
  EXPECT_EQ(run(), "");
  EXPECT_TRUE(std::isinf(lms_.next_event_s()));
  EXPECT_EQ(ask("GD0000000001\n"), "GD0000000001\n10Q\n\n");
}

TEST_F(EmulatedScipTest, StreamsUntilItIsStopped) {
  ask("ME0000000101000\n");
  int num_scans = 0;
  for (int i = 0; i < 400; ++i, now_s_ += 0.0025) num_scans += run().find("99b") != std::string::npos ? 1 : 0;
  EXPECT_NEAR(num_scans, 40, 2);  // 2400 turns a minute
  EXPECT_EQ(ask("QT\n"), "QT\n00P\n\n");
  now_s_ += 1.0;
  EXPECT_EQ(run(), "");
}

TEST_F(EmulatedScipTest, SetsItsClock) {
  EXPECT_EQ(ask("TM1\n"), "TM1\n04T\n\n");
  EXPECT_EQ(ask("TM0\n"), "TM0\n00P\n\n");
  EXPECT_EQ(ask("QT\n"), "QT\n0Ee\n\n");
  EXPECT_EQ(ask("TM1\n").substr(0, 8), "TM1\n00P\n");
  EXPECT_EQ(ask("TM2\n"), "TM2\n00P\n\n");
  EXPECT_EQ(ask("QT\n"), "QT\n00P\n\n");
}

TEST(EmulatedScip1Test, WantsToBeSwitched) {
  tests::WideSensor source;
  EmulatedScip urg({.parameters = urg_04lx(), .starts_in_scip_1 = true}, source);
  const auto ask = [&](const std::string& text) {
    urg.receive({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, 0.0);
    Bytes out;
    urg.run(0.0, out);
    return std::string(out.begin(), out.end());
  };
  EXPECT_EQ(ask("QT\n"), "QT\nE\n\n");
  EXPECT_EQ(ask("SCIP2.0\n"), "SCIP2.0\n0\n\n");
  EXPECT_EQ(ask("QT\n"), "QT\n00P\n\n");
}

}  // namespace
}  // namespace scanbed::hw
