// SPDX-License-Identifier: MIT
#include "hw/serial/serial_port.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "core/errors/sensor_fault.hpp"
#include "hw/serial/pseudo_terminal.hpp"
#include "hw/serial/steady_clock.hpp"
#include "tests/support/least_time.hpp"

namespace scanbed::hw {
namespace {

std::string fault_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const SensorFault& fault) {
    return fault.what();
  }
  return "";
}

TEST(SerialPortTest, SaysWhatToDo) {
  EXPECT_NE(fault_of([] { SerialPort("/dev/no_such_port"); }).find("no such port"), std::string::npos);
  EXPECT_NE(fault_of([] { SerialPort("/dev/null"); }).find("not a serial port"), std::string::npos);
  PseudoTerminal terminal({});
  const SerialPort first(terminal.path());
  EXPECT_NE(fault_of([&] { const SerialPort second(terminal.path()); }).find("in use"), std::string::npos);
}

TEST(SerialPortTest, AClosedPortIsFree) {
  PseudoTerminal terminal({});
  { const SerialPort port(terminal.path()); }
  EXPECT_NO_THROW(SerialPort(terminal.path()));
}

// The superuser may open a port that is marked as exclusive, others may not: so the mark itself is looked at.
// Who is killed cannot take the mark away, and the other end keeps the port open.
TEST(SerialPortTest, MarksNoPseudoTerminalAsItsOwn) {
  PseudoTerminal terminal({});
  const FileDescriptor other(::open(terminal.path().c_str(), O_RDWR | O_NOCTTY));
  ASSERT_TRUE(other.is_open());
  const auto is_exclusive = [&] {
    int mark = -1;
    EXPECT_EQ(::ioctl(other.get(), TIOCGEXCL, &mark), 0);
    return mark != 0;
  };
  {
    const SerialPort port(terminal.path());
    EXPECT_FALSE(is_exclusive());
  }
  EXPECT_FALSE(is_exclusive());
}

TEST(SerialPortTest, ReadingWaitsForTheTimeGivenAndNoLonger) {
  PseudoTerminal terminal({});
  SerialPort port(terminal.path());
  const StopSignal stop;
  std::array<std::uint8_t, 8> buffer{};
  const double least_s = tests::least_seconds(0.15, [&] { EXPECT_EQ(port.read(buffer, 0.1, stop), 0U); });
  EXPECT_GE(least_s, 0.099);
  EXPECT_LT(least_s, 0.15);
}

// A program that does not know termios2 reads the code of the standard table alone.
TEST(SerialPortTest, SetsAnyBaudAndTheStandardOnesByTheirCode) {
  PseudoTerminal terminal({});
  SerialPort port(terminal.path());
  const std::vector<std::pair<int, speed_t>> standard = {
      {9600, B9600}, {19200, B19200}, {38400, B38400}, {57600, B57600}, {115200, B115200}, {500000, B500000}};
  for (const auto& [baud, code] : standard) {
    port.set_baud(baud);
    EXPECT_EQ(terminal.host_baud(), baud);
    termios settings{};
    ASSERT_EQ(tcgetattr(terminal.fd(), &settings), 0);
    EXPECT_EQ(cfgetospeed(&settings), code) << baud;
    EXPECT_EQ(cfgetispeed(&settings), code) << baud;
  }
  port.set_baud(123456);
  EXPECT_EQ(terminal.host_baud(), 123456);
  EXPECT_DOUBLE_EQ(port.byte_s(), 10.0 / 123456);
}

TEST(SerialPortTest, FlushForgetsWhatArrived) {
  PseudoTerminal terminal({});
  SerialPort port(terminal.path());
  const StopSignal stop;
  terminal.write(Bytes{1, 2, 3});
  std::array<std::uint8_t, 1> one{};
  ASSERT_EQ(port.read(one, 20.0, stop), 1U);
  port.flush_input();
  EXPECT_EQ(port.read(one, 0.05, stop), 0U);
}

// At 500000 baud an LMS wants 55 us from byte to byte.
TEST(SerialPortTest, PacesFastWrites) {
  PseudoTerminal terminal({});
  SerialPort port(terminal.path());
  port.set_baud(500000);
  const StopSignal stop;
  const double start_s = steady_now_s();
  port.write(Bytes(50, 7), stop);
  EXPECT_GE(steady_now_s() - start_s, 50 * 55e-6);
  Bytes got;
  terminal.read(got);
  EXPECT_EQ(got.size(), 50U);
}

TEST(SerialPortTest, AFullPortTimesOut) {
  PseudoTerminal terminal({});
  SerialPort port(terminal.path());
  port.set_baud(115200);
  const StopSignal stop;
  EXPECT_NE(fault_of([&] { port.write(Bytes(30000, 7), stop); }), "");
}

}  // namespace
}  // namespace scanbed::hw
