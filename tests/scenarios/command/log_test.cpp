// SPDX-License-Identifier: MIT
#include "scenarios/command/log.hpp"

#include <gtest/gtest.h>

namespace scanbed::scenarios {
namespace {

template <typename Action>
std::string captured(Action&& action) {
  ::testing::internal::CaptureStderr();
  action();
  return ::testing::internal::GetCapturedStderr();
}

// Standard error is no terminal here, so there is no colour either.
TEST(LogTest, WritesOneLineWithItsKind) {
  EXPECT_EQ(captured([] { log_error("no such file"); }), "scanbed: error: no such file\n");
  EXPECT_EQ(captured([] { log_warning("odd"); }), "scanbed: warning: odd\n");
  EXPECT_EQ(captured([] { log_note("3 scans"); }), "scanbed: 3 scans\n");
}

TEST(LogTest, LetsNoMessageBreakTheLineOrTheTerminal) {
  EXPECT_EQ(captured([] { log_error("a\nb\x1b[31m {} %v"); }), "scanbed: error: a?b?[31m {} %v\n");
}

}  // namespace
}  // namespace scanbed::scenarios
