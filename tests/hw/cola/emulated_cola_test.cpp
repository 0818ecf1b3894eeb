// SPDX-License-Identifier: MIT
#include "hw/cola/emulated_cola.hpp"

#include <gtest/gtest.h>

#include "hw/cola/cola_scan.hpp"
#include "tests/support/wide_sensor.hpp"

namespace scanbed::hw {
namespace {

class EmulatedColaTest : public ::testing::Test {
 protected:
  /// The first body of the answer.
  std::string ask(const std::string& body) {
    sensor_.receive(frame_cola(body), now_s_);
    return run();
  }
  std::string run() {
    Bytes out;
    sensor_.run(now_s_, out);
    ColaReader reader;
    reader.feed(out);
    std::string body;
    return reader.next(body) ? body : "";
  }

  tests::WideSensor source_;
  EmulatedCola sensor_{{}, source_};
  double now_s_ = 10.0;
};

TEST_F(EmulatedColaTest, AnswersAsListed) {
  EXPECT_EQ(ask("sMN SetAccessMode 03 F4724744"), "sAN SetAccessMode 1");
  EXPECT_EQ(ask("sMN SetAccessMode 3 F4724744"), "sAN SetAccessMode 1");
  EXPECT_EQ(ask("sMN SetAccessMode 03 00000000"), "sAN SetAccessMode 0");
  EXPECT_EQ(ask("sRN DeviceIdent"), "sRA DeviceIdent 10 LMS10x_FieldEval 10 V1.36-21.10.2010");
  EXPECT_EQ(ask("sMN Run"), "sAN Run 1");
  EXPECT_EQ(ask("sRN Nonsense"), "sFA 3");
  EXPECT_EQ(ask("sMN Nonsense"), "sFA 2");
  EXPECT_EQ(ask("xyz"), "sFA C");
}

TEST_F(EmulatedColaTest, WantsALogInForWrites) {
  EXPECT_EQ(ask("sWN LMDscandatacfg 01 00 0 0 0 00 00 0 0 0 0 +1"), "sFA A");
  ask("sMN SetAccessMode 03 F4724744");
  EXPECT_EQ(ask("sWN LMDscandatacfg 01 00 0 0 0 00 00 0 0 0 0 +1"), "sWA LMDscandatacfg");
  EXPECT_EQ(ask("sMN LMCstartmeas"), "sAN LMCstartmeas 0");
}

TEST_F(EmulatedColaTest, TellsWhenItsMotorIsUp) {
  EXPECT_TRUE(ask("sRN STlms").starts_with("sRA STlms 4"));
  EXPECT_TRUE(ask("sRN STlms").starts_with("sRA STlms 4"));
  EXPECT_TRUE(ask("sRN STlms").starts_with("sRA STlms 7"));
}

TEST_F(EmulatedColaTest, SendsNothingWhileSomebodyIsLoggedIn) {
  ask("sMN SetAccessMode 03 F4724744");
  EXPECT_EQ(ask("sEN LMDscandata 1"), "sEA LMDscandata 1");
  now_s_ += 1.0;
  EXPECT_EQ(run(), "");
  EXPECT_EQ(ask("sMN Run"), "sAN Run 1");
  now_s_ += 1.0;
  EXPECT_TRUE(run().starts_with("sSN LMDscandata "));
}

TEST_F(EmulatedColaTest, ItsScansAreThoseOfItsSource) {
  const auto telegram = parse_cola_scan(ask("sRN LMDscandata"));
  ASSERT_TRUE(telegram.has_value());
  EXPECT_EQ(telegram->channels.at(0).values.size(), 541u);
  EXPECT_EQ(telegram->channels.at(0).values[0], 1180u);  // -135 degrees is beam 180 of the source
  EXPECT_EQ(telegram->sent_us, 10000000u);
  EXPECT_EQ(telegram->start_us, 9996000u);
}

}  // namespace
}  // namespace scanbed::hw
