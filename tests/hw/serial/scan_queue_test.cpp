// SPDX-License-Identifier: MIT
#include "hw/serial/scan_queue.hpp"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>

#include "hw/serial/stop_signal.hpp"

namespace scanbed::hw {
namespace {

using Full = ScanQueue::Full;
using Popped = ScanQueue::Popped;
constexpr RangeSensor::Seconds kLongWait{20.0};
constexpr RangeSensor::Seconds kNoWait{0.0};

void push(int count, ScanQueue& queue) {
  LaserScan scan;
  for (int i = 0; i < count; ++i) queue.push(scan);
}

TEST(ScanQueueTest, NumbersScansAndKeepsTheirOrder) {
  ScanQueue queue(4, Full::kDropsOldest);
  push(3, queue);
  LaserScan scan;
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(queue.pop(scan, kNoWait), Popped::kScan);
    EXPECT_EQ(scan.index, i);
  }
  EXPECT_EQ(queue.pop(scan, kNoWait), Popped::kTimeout);
}

TEST(ScanQueueTest, DropsTheOldestWhereNobodyTakesThem) {
  ScanQueue queue(3, Full::kDropsOldest);
  push(10, queue);
  LaserScan scan;
  ASSERT_EQ(queue.pop(scan, kNoWait), Popped::kScan);
  EXPECT_EQ(scan.index, 7);
  EXPECT_EQ(queue.num_pushed(), 10);
  EXPECT_EQ(queue.num_dropped(), 7);
}

TEST(ScanQueueTest, WaitsForRoomWhereNothingMayBeLost) {
  ScanQueue queue(2, Full::kWaits);
  const auto pusher = std::async(std::launch::async, [&] { push(50, queue); });
  LaserScan scan;
  for (int i = 0; i < 50; ++i) {
    ASSERT_EQ(queue.pop(scan, kLongWait), Popped::kScan);
    EXPECT_EQ(scan.index, i);
  }
  EXPECT_EQ(queue.num_dropped(), 0);
}

TEST(ScanQueueTest, ClosingEndsWhoeverWaits) {
  ScanQueue queue(1, Full::kWaits);
  push(1, queue);
  auto pusher = std::async(std::launch::async, [&] { push(1, queue); });
  queue.close();
  EXPECT_THROW(pusher.get(), Stopped);
  LaserScan scan;
  EXPECT_EQ(queue.pop(scan, kLongWait), Popped::kClosed);
}

TEST(ScanQueueTest, TheReasonOfAFailureComesAfterTheLastScan) {
  ScanQueue queue(2, Full::kDropsOldest);
  push(1, queue);
  queue.fail(std::make_exception_ptr(std::runtime_error("unplugged")));
  LaserScan scan;
  EXPECT_EQ(queue.pop(scan, kLongWait), Popped::kScan);
  for (int i = 0; i < 2; ++i) EXPECT_THROW(queue.pop(scan, kLongWait), std::runtime_error);
}

}  // namespace
}  // namespace scanbed::hw
