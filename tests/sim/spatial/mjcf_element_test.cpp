// SPDX-License-Identifier: MIT
#include "sim/spatial/mjcf_element.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace scanbed::sim {
namespace {

TEST(MjcfElementTest, NumbersReadBackToTheSameDoubles) {
  const std::string text = mjcf_numbers({0.1, -2.5e-9, 1.0 / 3.0, 7.0});
  std::istringstream reader(text);
  double a = 0.0;
  double b = 0.0;
  double c = 0.0;
  double d = 0.0;
  reader >> a >> b >> c >> d;
  EXPECT_EQ(a, 0.1);
  EXPECT_EQ(b, -2.5e-9);
  EXPECT_EQ(c, 1.0 / 3.0);
  EXPECT_EQ(d, 7.0);
  EXPECT_EQ(mjcf_numbers({7.0, 0.5}), "7 0.5");
  EXPECT_EQ(mjcf_numbers({}), "");
}

TEST(MjcfElementTest, AttributesAreEscaped) {
  pugi::xml_document document;
  MjcfElement(document, "geom").set("name", "a<b>&\"c'").set("size", {1.0, 2.0}).set_color({0.5, 0.25, 1.0});
  std::ostringstream text;
  document.save(text, "", pugi::format_raw | pugi::format_no_declaration);
  EXPECT_EQ(text.str().find("a<b"), std::string::npos);

  pugi::xml_document again;
  ASSERT_TRUE(again.load_string(text.str().c_str()));
  EXPECT_STREQ(again.child("geom").attribute("name").value(), "a<b>&\"c'");
  EXPECT_STREQ(again.child("geom").attribute("size").value(), "1 2");
  EXPECT_STREQ(again.child("geom").attribute("rgba").value(), "0.5 0.25 1 1");
}

TEST(MjcfElementTest, WhatIsPulledMeetsTheScriptedAndItsLikeButTheScriptedDoNotMeet) {
  const auto meet = [](const GeomRole& a, const GeomRole& b) {
    return (a.contype & b.conaffinity) != 0 || (b.contype & a.conaffinity) != 0;  // MuJoCo's rule
  };
  EXPECT_TRUE(meet(kSeenPulled, kSeenScripted));
  EXPECT_TRUE(meet(kSeenPulled, kPictureScripted));
  EXPECT_TRUE(meet(kSeenPulled, kSeenPulled));
  EXPECT_FALSE(meet(kSeenScripted, kPictureScripted));
  EXPECT_FALSE(meet(kSeenPulled, kLaserOnly));
  EXPECT_FALSE(meet(kSeenPulled, kSeenOnly));
}

}  // namespace
}  // namespace scanbed::sim
