// SPDX-License-Identifier: MIT
#include "scenarios/command/source_watch.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace scanbed::scenarios {
namespace {

std::string told_of(const std::string& laser, const std::vector<std::string>& sources) {
  ::testing::internal::CaptureStderr();
  SourceWatch watch(parse_laser_spec(laser));
  for (const std::string& source : sources) {
    LaserScan scan;
    scan.source = source;
    watch.see(scan);
  }
  return ::testing::internal::GetCapturedStderr();
}

TEST(SourceWatchTest, TellsOnceWhichLasersAreMixed) {
  EXPECT_EQ(told_of("log:a.log", {"FLASER", "FLASER", "RLASER", "FLASER", "X"}),
            "scanbed: warning: a.log: mixes scans of several lasers, 'FLASER' and 'RLASER'; read one with "
            "log:a.log?only=FLASER\n");
}

TEST(SourceWatchTest, NamesALaserThatHasAName) {
  EXPECT_EQ(told_of("log:a.log", {"", "RLASER"}),
            "scanbed: warning: a.log: mixes scans of several lasers, '' and 'RLASER'; read one with "
            "log:a.log?only=RLASER\n");
}

TEST(SourceWatchTest, IsSilentWhereThereIsOneOrOneWasAskedFor) {
  EXPECT_EQ(told_of("log:a.log", {"FLASER", "FLASER"}), "");
  EXPECT_EQ(told_of("log:a.log?only=FLASER", {"FLASER", "RLASER"}), "");
  EXPECT_EQ(told_of("sim:hall", {"a", "b"}), "");
}

}  // namespace
}  // namespace scanbed::scenarios
