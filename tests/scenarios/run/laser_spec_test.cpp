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

TEST(ParseLaserSpecTest, ReadsAnLmsWithItsOptions) {
  const LaserSpec plain = parse_laser_spec("sick:/dev/serial/by-id/usb-x");
  EXPECT_EQ(plain.kind, LaserKind::kSick);
  EXPECT_TRUE(plain.is_device());
  EXPECT_EQ(plain.sick.path, "/dev/serial/by-id/usb-x");
  EXPECT_EQ(plain.sick.baud, 38400);
  const LaserSpec full = parse_laser_spec(
      "sick:/dev/ttyS0?baud=500000&fov_deg=100&resolution_deg=0.25&unit=cm&mode=3&lossless=1");
  EXPECT_EQ(full.sick.baud, 500000);
  EXPECT_EQ(full.sick.fov_deg, 100);
  EXPECT_EQ(full.sick.resolution_cdeg, 25);
  EXPECT_EQ(full.sick.unit, RangeUnit::kCentimetre);
  EXPECT_EQ(full.sick.measuring_mode, 3);
  EXPECT_TRUE(full.sick.is_lossless);
}

TEST(ParseLaserSpecTest, RefusesAnLmsThatCannotBe) {
  EXPECT_NE(spec_error("sick:").find("no port"), std::string::npos);
  EXPECT_NE(spec_error("sick:x?baud=115200").find("sick.baud"), std::string::npos);
  EXPECT_NE(spec_error("sick:x?baud=fast").find("baud: expected a whole number"), std::string::npos);
  EXPECT_NE(spec_error("sick:x?unit=m").find("expected mm or cm"), std::string::npos);
  EXPECT_NE(spec_error("sick:x?resolution_deg=wide").find("expected degrees"), std::string::npos);
  EXPECT_NE(spec_error("sick:x?resolution_deg=0.504").find("steps of 0.01"), std::string::npos);
  EXPECT_NE(spec_error("sick:x?mode=300").find("sick.mode: value 300"), std::string::npos);
  EXPECT_NE(spec_error("sick:x?bard=9600").find("did you mean 'baud'"), std::string::npos);
}

TEST(ParseLaserSpecTest, ReadsOtherSensors) {
  const LaserSpec serial = parse_laser_spec("scip:/dev/ttyACM0?baud=19200");
  EXPECT_EQ(serial.kind, LaserKind::kScip);
  EXPECT_EQ(serial.scip.path, "/dev/ttyACM0");
  EXPECT_EQ(serial.scip.baud, 19200);
  EXPECT_EQ(parse_laser_spec("scip:./ttyACM0").scip.path, "./ttyACM0");
  EXPECT_EQ(parse_laser_spec("scip:192.168.0.10").scip.port, 10940);
  EXPECT_EQ(parse_laser_spec("scip:laser.local:1234").scip.host, "laser.local");
  EXPECT_EQ(parse_laser_spec("scip:laser.local:1234").scip.port, 1234);
  const LaserSpec cola = parse_laser_spec("cola:192.168.0.1:2112");
  EXPECT_EQ(cola.kind, LaserKind::kCola);
  EXPECT_EQ(cola.cola.host, "192.168.0.1");
  EXPECT_EQ(cola.cola.port, 2112);
  EXPECT_EQ(parse_laser_spec("cola:fe80::1").cola.host, "fe80::1");
  EXPECT_NE(spec_error("cola:").find("no host"), std::string::npos);
  EXPECT_NE(spec_error("cola:h:x").find("port: expected a whole number"), std::string::npos);
  EXPECT_NE(spec_error("cola:h?baud=1").find("unknown option"), std::string::npos);
  EXPECT_NE(spec_error("scip:").find("no port"), std::string::npos);
  EXPECT_NE(spec_error("scip:h:70000").find("scip.port"), std::string::npos);
}

TEST(ParseLaserSpecTest, CutsAtTheLastQuestionMark) {
  EXPECT_EQ(parse_laser_spec("log:what?.log?only=FLASER").target, "what?.log");
  const testing::TemporaryFolder folder;
  const std::string file = testing::write_file(folder / "what?.log", "");
  EXPECT_EQ(parse_laser_spec("log:" + file).target, file);
}

TEST(ParseLaserSpecTest, RefusesWithWhatToDo) {
  EXPECT_EQ(spec_error("player:localhost:6665"),
            "--laser 'player:localhost:6665': player is not available yet; use sim, log:FILE, sick:PORT, "
            "scip:PORT or cola:HOST");
  EXPECT_EQ(spec_error("lgo:a.log"),
            "--laser 'lgo:a.log': unknown kind of laser; did you mean 'log'?; use sim, log:FILE, sick:PORT, "
            "scip:PORT or cola:HOST");
  EXPECT_EQ(spec_error("foobar:"),
            "--laser 'foobar:': unknown kind of laser; known kinds: sim, log, sick, scip, cola; use sim, "
            "log:FILE, sick:PORT, scip:PORT or cola:HOST");
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

TEST(LaserSpecTest, RefusesAnOptionThatIsGivenTwice) {
  EXPECT_EQ(testing::error_of([] { parse_laser_spec("log:a?from=1&to=3&from=2"); }),
            "--laser 'log:a?from=1&to=3&from=2': from: is given twice");
}

}  // namespace
}  // namespace scanbed::scenarios
