// SPDX-License-Identifier: MIT
#include "hw/scip/scip_parameters.hpp"

#include <gtest/gtest.h>

namespace scanbed::hw {
namespace {

// As a UTM-30LX sent it.
const std::vector<std::string> kUtm = {
    "PP",         "00P",          "MODL:UTM-30LX(Hokuyo Automatic Co.,Ltd.);U",
    "DMIN:23;7",  "DMAX:60000;J", "ARES:1440;^",
    "AMIN:0;?",   "AMAX:1080;Z",  "AFRT:540;0",
    "SCAN:2400;U"};

TEST(ScipParametersTest, ReadsWhatARealSensorSent) {
  const auto p = parse_scip_parameters(kUtm);
  ASSERT_TRUE(p.has_value());
  EXPECT_EQ(p->model, "UTM-30LX(Hokuyo Automatic Co.,Ltd.)");
  EXPECT_EQ(p->num_beams(), 1081);
  EXPECT_DOUBLE_EQ(p->scan_period_s(), 0.025);
  EXPECT_NEAR(p->geometry().first_rad, radians(-135.0), 1e-12);
  EXPECT_NEAR(p->geometry().step_rad, radians(0.25), 1e-12);
  EXPECT_EQ(p->geometry().max_range_m, 60.0);
}

TEST(ScipParametersTest, WritesWhatRealSensorsSent) {
  EXPECT_EQ(to_scip_info(utm_30lx()),
            "MODL:UTM-30LX(Hokuyo Automatic Co.,Ltd.);U\nDMIN:23;7\nDMAX:60000;J\nARES:1440;^\nAMIN:0;?\n"
            "AMAX:1080;Z\nAFRT:540;0\nSCAN:2400;U\n");
  EXPECT_EQ(to_scip_info(urg_04lx()),
            "MODL:URG-04LX(Hokuyo Automatic Co.,Ltd.);N\nDMIN:20;4\nDMAX:5600;_\nARES:1024;\\\nAMIN:44;7\n"
            "AMAX:725;o\nAFRT:384;6\nSCAN:600;e\n");
}

TEST(ScipParametersTest, TheUrgSeesFromMinus119Point53Degrees) {
  EXPECT_EQ(urg_04lx().num_beams(), 682);
  EXPECT_NEAR(degrees(urg_04lx().geometry().first_rad), -119.53, 0.01);
}

TEST(ScipParametersTest, IgnoresUnknownKeysAndTakesSumsWithTheSemicolon) {
  std::vector<std::string> lines = kUtm;
  lines.push_back("PROT:SCIP 2.0;N");
  lines[3] = "DMIN:23;2";  // the sum of "DMIN:23;"
  EXPECT_TRUE(parse_scip_parameters(lines).has_value());
}

TEST(ScipParametersTest, RefusesWhatIsMissingDamagedOrImpossible) {
  for (std::size_t i = 3; i < kUtm.size(); ++i) {
    std::vector<std::string> lines = kUtm;
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(parse_scip_parameters(lines).has_value()) << kUtm[i];
  }
  std::vector<std::string> lines = kUtm;
  lines[5].back() = '_';
  EXPECT_FALSE(parse_scip_parameters(lines).has_value());
  lines = kUtm;
  lines[9] = scip_info_line("SCAN:0");
  lines[9].pop_back();
  EXPECT_FALSE(parse_scip_parameters(lines).has_value());
  EXPECT_FALSE(parse_scip_parameters({}).has_value());
}

}  // namespace
}  // namespace scanbed::hw
