// SPDX-License-Identifier: MIT
#include "hw/serial/device_server.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <limits>
#include <thread>

#include "hw/serial/serial_port.hpp"
#include "tests/support/running_device.hpp"

namespace scanbed::hw {
namespace {

/// Says each byte back, one higher.
class Echo final : public ByteDevice {
 public:
  void receive(ByteView bytes, double /*now_s*/) override {
    for (const std::uint8_t byte : bytes) waiting_.push_back(static_cast<std::uint8_t>(byte + 1));
  }
  void run(double /*now_s*/, Bytes& out) override {
    out.insert(out.end(), waiting_.begin(), waiting_.end());
    waiting_.clear();
  }
  double next_event_s() const override { return std::numeric_limits<double>::infinity(); }
  void hang_up() override { ++num_hang_ups; }

  std::atomic<int> num_hang_ups = 0;

 private:
  Bytes waiting_;
};

std::uint8_t ask(ByteLink& link, std::uint8_t byte) {
  const StopSignal stop;
  link.write(Bytes{byte}, stop);
  std::array<std::uint8_t, 1> answer{};
  return link.read(answer, 5.0, stop) == 1 ? answer[0] : 0;
}

TEST(DeviceServerTest, ServesOneHostAfterAnother) {
  Echo echo;
  tests::RunningDevice running(echo);
  const StopSignal stop;
  for (int i = 0; i < 3; ++i) {
    TcpLink link("127.0.0.1", running.port(), 5.0, stop);
    EXPECT_EQ(ask(link, 7), 8);
  }
  for (int i = 0; i < 100 && echo.num_hang_ups < 3; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(echo.num_hang_ups, 3);
}

TEST(DeviceServerTest, ServesAPseudoTerminal) {
  Echo echo;
  PseudoTerminal terminal({});
  StopSignal stop;
  std::thread thread([&] { serve(echo, terminal, stop); });
  {
    SerialPort port(terminal.path());
    EXPECT_EQ(ask(port, 41), 42);
  }
  stop.give();
  thread.join();
}

}  // namespace
}  // namespace scanbed::hw
