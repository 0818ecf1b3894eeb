// SPDX-License-Identifier: MIT
#include "scenarios/run/laser_spec.hpp"

#include <gtest/gtest.h>

#include "tests/scenarios/support.hpp"

namespace scanbed::scenarios {
namespace {

std::string spec_error(const std::string& text) {
  return testing::error_of([&] { parse_laser_spec(text); });
}

TEST(ParseLaserSpecTest, ReadsTheSimulatedLaser) {
  EXPECT_EQ(parse_laser_spec("sim").kind, LaserKind::kSimulated);
  EXPECT_EQ(parse_laser_spec("sim").target, "");
  EXPECT_EQ(parse_laser_spec("sim:static_hallway").target, "static_hallway");
}

TEST(ParseLaserSpecTest, ReadsALogWithItsOptions) {
  const LaserSpec plain = parse_laser_spec("log:a/b.log.gz");
  EXPECT_EQ(plain.kind, LaserKind::kLog);
  EXPECT_EQ(plain.target, "a/b.log.gz");
  EXPECT_EQ(plain.log.only, "");
  EXPECT_EQ(plain.log.no_return_m, hw::RecordingOptions{}.no_return_m);
  const LaserSpec full = parse_laser_spec("log:a.log?only=RLASER&no_return=8.1");
  EXPECT_EQ(full.target, "a.log");
  EXPECT_EQ(full.log.only, "RLASER");
  EXPECT_EQ(full.log.no_return_m, 8.1);
  EXPECT_EQ(full.text, "log:a.log?only=RLASER&no_return=8.1");
}

TEST(ParseLaserSpecTest, CutsAtTheLastQuestionMark) {
  EXPECT_EQ(parse_laser_spec("log:what?.log?only=FLASER").target, "what?.log");
}

TEST(ParseLaserSpecTest, RefusesWithWhatToDo) {
  EXPECT_EQ(spec_error("sick:/dev/ttyUSB0"),
            "--laser 'sick:/dev/ttyUSB0': sick is not available yet; use sim or log:FILE");
  EXPECT_EQ(spec_error("player:localhost:6665"),
            "--laser 'player:localhost:6665': player is not available yet; use sim or log:FILE");
  EXPECT_EQ(spec_error("lgo:a.log"),
            "--laser 'lgo:a.log': unknown kind of laser; did you mean 'log'?; use sim or log:FILE");
  EXPECT_EQ(spec_error("log:"), "--laser 'log:': no file; write log:FILE");
  EXPECT_EQ(spec_error("log"), "--laser 'log': no file; write log:FILE");
  EXPECT_EQ(spec_error("log:a?noreturn=3"),
            "--laser 'log:a?noreturn=3': unknown option 'noreturn'; did you mean 'no_return'?");
  EXPECT_EQ(spec_error("log:a?no_return=0"),
            "--laser 'log:a?no_return=0': no_return: expected metres > 0, found '0'");
  EXPECT_EQ(spec_error("log:a?no_return"),
            "--laser 'log:a?no_return': no_return: expected metres > 0, found ''");
  EXPECT_EQ(spec_error("log:a?only="), "--laser 'log:a?only=': only: expected a message such as FLASER");
  EXPECT_NE(spec_error(""), "");
}

TEST(ParseLaserSpecTest, ReadsHowALogIsReplayed) {
  const LaserSpec spec = parse_laser_spec("log:a.bag?speed=2&from=1.5&to=10");
  EXPECT_EQ(spec.target, "a.bag");
  EXPECT_EQ(spec.replay.speed, 2.0);
  EXPECT_EQ(spec.replay.from_s, 1.5);
  EXPECT_EQ(spec.replay.to_s, 10.0);
  EXPECT_FALSE(parse_laser_spec("log:a.bag").replay.speed.has_value());
  EXPECT_THROW(parse_laser_spec("log:a.bag?speed=fast"), InputError);
  EXPECT_THROW(parse_laser_spec("log:a.bag?from="), InputError);
}

}  // namespace
}  // namespace scanbed::scenarios
