// SPDX-License-Identifier: MIT
#include "hw/serial/tcp_link.hpp"

#include <gtest/gtest.h>
#include <poll.h>

#include <array>

#include "core/errors/sensor_fault.hpp"
#include "hw/serial/steady_clock.hpp"

namespace scanbed::hw {
namespace {

class TcpLinkTest : public ::testing::Test {
 protected:
  TcpLink accept() {
    wait_for(listener_.fd(), POLLIN, 20.0, stop_);
    return TcpLink(listener_.accept());
  }

  StopSignal stop_;
  TcpListener listener_{0};
};

TEST_F(TcpLinkTest, CarriesBytesBothWays) {
  TcpLink here("127.0.0.1", listener_.port(), 20.0, stop_);
  TcpLink there = accept();
  std::array<std::uint8_t, 16> buffer{};
  here.write(Bytes{1, 2, 3}, stop_);
  EXPECT_EQ(there.read(buffer, 20.0, stop_), 3u);
  there.write(Bytes{4, 5}, stop_);
  EXPECT_EQ(here.read(buffer, 20.0, stop_), 2u);
  EXPECT_EQ(buffer[1], 5);
}

TEST_F(TcpLinkTest, NoticesThatTheOtherEndIsGone) {
  TcpLink here("127.0.0.1", listener_.port(), 20.0, stop_);
  { TcpLink there = accept(); }
  std::array<std::uint8_t, 16> buffer{};
  EXPECT_THROW(here.read(buffer, 20.0, stop_), SensorFault);
}

TEST_F(TcpLinkTest, ReadsNothingWhereNothingComes) {
  TcpLink here("127.0.0.1", listener_.port(), 20.0, stop_);
  std::array<std::uint8_t, 16> buffer{};
  const double start_s = steady_now_s();
  EXPECT_EQ(here.read(buffer, 0.05, stop_), 0u);
  EXPECT_GE(steady_now_s() - start_s, 0.049);
}

TEST_F(TcpLinkTest, FlushForgetsWhatArrived) {
  TcpLink here("127.0.0.1", listener_.port(), 20.0, stop_);
  TcpLink there = accept();
  there.write(Bytes{1, 2}, stop_);
  std::array<std::uint8_t, 1> one{};
  ASSERT_EQ(here.read(one, 20.0, stop_), 1u);
  here.flush_input();
  EXPECT_EQ(here.read(one, 0.02, stop_), 0u);
}

TEST(TcpLinkFaultTest, SaysWhyItCannotConnect) {
  const StopSignal stop;
  int port = 0;
  {
    TcpListener closed(0);
    port = closed.port();
  }
  try {
    TcpLink link("127.0.0.1", port, 1.0, stop);
    FAIL();
  } catch (const SensorFault& fault) {
    EXPECT_NE(std::string(fault.what()).find("cannot connect"), std::string::npos) << fault.what();
  }
}

TEST(TcpLinkFaultTest, APortThatIsTakenIsAFault) {
  const TcpListener first(0);
  EXPECT_THROW(TcpListener{first.port()}, SensorFault);
}

}  // namespace
}  // namespace scanbed::hw
