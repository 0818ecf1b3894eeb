// SPDX-License-Identifier: MIT
#include "hw/serial/stop_signal.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/eventfd.h>

#include <thread>

#include "hw/serial/steady_clock.hpp"

namespace scanbed::hw {
namespace {

TEST(StopSignalTest, WaitsForTheTimeGiven) {
  const StopSignal stop;
  const double start_s = steady_now_s();
  EXPECT_FALSE(wait_for(-1, 0, 0.05, stop));
  EXPECT_GE(steady_now_s() - start_s, 0.05);
}

TEST(StopSignalTest, EndsAWaitOfAnotherThread) {
  StopSignal stop;
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    stop.give();
  });
  const double start_s = steady_now_s();
  EXPECT_THROW(stop.sleep(30.0), Stopped);
  EXPECT_LT(steady_now_s() - start_s, 5.0);
  other.join();
}

TEST(StopSignalTest, IsGivenForGood) {
  StopSignal stop;
  EXPECT_FALSE(stop.is_given());
  stop.give();
  EXPECT_TRUE(stop.is_given());
  EXPECT_THROW(stop.sleep(0.0), Stopped);
  EXPECT_THROW(stop.sleep(0.0), Stopped);
}

TEST(StopSignalTest, SeesADescriptorThatIsReady) {
  const StopSignal stop;
  const FileDescriptor ready(eventfd(1, EFD_CLOEXEC));
  const FileDescriptor idle(eventfd(0, EFD_CLOEXEC));
  EXPECT_TRUE(wait_for(ready.get(), POLLIN, 1.0, stop));
  EXPECT_FALSE(wait_for(idle.get(), POLLIN, 0.0, stop));
}

}  // namespace
}  // namespace scanbed::hw
