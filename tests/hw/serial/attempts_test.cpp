// SPDX-License-Identifier: MIT
#include "hw/serial/attempts.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "hw/serial/device_refusal.hpp"

namespace scanbed::hw {
namespace {

using Kind = SensorFault::Kind;

/// What ends attempts that all fail alike, and after how many.
struct Ended {
  int num_attempts = 0;
  std::exception_ptr reason;
};

template <typename Fault>
Ended fail_with(const Fault& fault, int most) {
  Ended ended;
  const Attempts attempts{.device = "/dev/laser",
                          .pause_s = 0.0,
                          .attempt =
                              [&] {
                                ++ended.num_attempts;
                                throw fault;
                              },
                          .may_go_on = [&](const SensorFault&) { return ended.num_attempts < most; }};
  ended.reason = keep_trying(attempts, StopSignal());
  return ended;
}

SensorFault fault_of(const Ended& ended) {
  try {
    std::rethrow_exception(ended.reason);
  } catch (const SensorFault& fault) {
    return fault;
  }
}

TEST(KeepTryingTest, EndsWithAFaultThatNamesTheDevice) {
  const Ended ended = fail_with(SensorFault(Kind::kProtocol, "no telegram"), 3);
  EXPECT_EQ(ended.num_attempts, 3);
  EXPECT_EQ(fault_of(ended).what(), std::string("/dev/laser: no telegram"));
  EXPECT_EQ(fault_of(ended).kind(), Kind::kProtocol);
  EXPECT_EQ(fault_of(fail_with(SensorFault(Kind::kProtocol, "/dev/laser: gone"), 1)).what(),
            std::string("/dev/laser: gone"));
}

// After a timeout one would ask again.
TEST(KeepTryingTest, ATimeoutThatEndsItIsNoneAnyMore) {
  EXPECT_EQ(fault_of(fail_with(SensorFault(Kind::kTimeout, "nothing answers"), 2)).kind(),
            Kind::kDisconnected);
}

TEST(KeepTryingTest, RefusalsAndOtherErrorsEndItAtOnce) {
  const Ended refused = fail_with(DeviceRefusal("no"), 9);
  EXPECT_EQ(refused.num_attempts, 1);
  EXPECT_THROW(std::rethrow_exception(refused.reason), DeviceRefusal);
  const Ended failed = fail_with(std::runtime_error("out of memory"), 9);
  EXPECT_EQ(failed.num_attempts, 1);
  EXPECT_THROW(std::rethrow_exception(failed.reason), std::runtime_error);
}

TEST(KeepTryingTest, TheSignalEndsItWithoutReason) {
  StopSignal stop;
  int num_attempts = 0;
  const Attempts attempts{.device = "laser",
                          .pause_s = 100.0,
                          .attempt =
                              [&] {
                                ++num_attempts;
                                stop.give();
                                throw SensorFault(Kind::kTimeout, "nothing answers");
                              },
                          .may_go_on = [](const SensorFault&) { return true; }};
  EXPECT_EQ(keep_trying(attempts, stop), nullptr);
  EXPECT_EQ(num_attempts, 1);
}

}  // namespace
}  // namespace scanbed::hw
