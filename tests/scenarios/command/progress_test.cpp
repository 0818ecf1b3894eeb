// SPDX-License-Identifier: MIT
#include "scenarios/command/progress.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace scanbed::scenarios {
namespace {

TEST(ProgressTest, IsSilentWhereStandardErrorIsNoTerminal) {
  ::testing::internal::CaptureStderr();
  {
    Progress progress("hall");
    progress.show(1);
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    progress.show(2);
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace scanbed::scenarios
