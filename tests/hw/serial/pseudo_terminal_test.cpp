// SPDX-License-Identifier: MIT
#include "hw/serial/pseudo_terminal.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>

#include "core/errors/input_error.hpp"
#include "core/errors/sensor_fault.hpp"
#include "hw/serial/serial_port.hpp"

namespace scanbed::hw {
namespace {

std::filesystem::path temporary(const char* name) {
  return std::filesystem::path(::testing::TempDir()) / (std::to_string(::getpid()) + name);
}

std::string fault_of(const std::filesystem::path& link) {
  try {
    PseudoTerminal terminal(link);
  } catch (const SensorFault& fault) {
    return fault.what();
  }
  return "";
}

TEST(PseudoTerminalTest, CarriesBytesBothWaysUnchanged) {
  PseudoTerminal terminal({});
  SerialPort port(terminal.path());
  const StopSignal stop;
  const Bytes all_kinds = {0x00, 0x03, 0x0A, 0x0D, 0x11, 0x13, 0x7F, 0xFF};
  EXPECT_EQ(terminal.write(all_kinds), all_kinds.size());
  std::array<std::uint8_t, 64> buffer{};
  const std::size_t count = port.read(buffer, 1.0, stop);
  EXPECT_EQ(Bytes(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(count)), all_kinds);
  port.write(all_kinds, stop);
  Bytes got;
  terminal.read(got);
  EXPECT_EQ(got, all_kinds);
}

TEST(PseudoTerminalTest, TellsTheBaudOfTheOtherEnd) {
  PseudoTerminal terminal({});
  SerialPort port(terminal.path());
  for (const int baud : {9600, 19200, 38400, 500000}) {
    port.set_baud(baud);
    EXPECT_EQ(terminal.host_baud(), baud);
  }
}

TEST(PseudoTerminalTest, LinksToItselfAndCleansUp) {
  const std::filesystem::path link = temporary("_link");
  {
    PseudoTerminal terminal(link);
    EXPECT_EQ(std::filesystem::read_symlink(link), terminal.path());
  }
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(link)));
}

TEST(PseudoTerminalTest, ReplacesNoFile) {
  const std::filesystem::path file = temporary("_file");
  std::ofstream(file) << "precious";
  EXPECT_THROW(PseudoTerminal{file}, InputError);
  EXPECT_TRUE(std::filesystem::is_regular_file(file));
}

TEST(PseudoTerminalTest, SaysWhyALinkCannotBeMade) {
  EXPECT_EQ(fault_of("/no/such/folder/link"),
            "/no/such/folder/link: cannot make the link: No such file or directory");
}

TEST(PseudoTerminalTest, LeavesTheLinkToWhoHasIt) {
  const std::filesystem::path link = temporary("_shared");
  PseudoTerminal first(link);
  EXPECT_EQ(fault_of(link),
            link.string() + ": another emulator is at this name; end it, or choose another name");
  {
    const SerialPort host(link.string());  // others cannot even open it
    EXPECT_NE(fault_of(link), "");
  }
  EXPECT_EQ(std::filesystem::read_symlink(link), first.path());
}

TEST(PseudoTerminalTest, ReplacesALinkThatNobodyServes) {
  const std::filesystem::path link = temporary("_stale");
  // Both what a killed emulator leaves behind, and its number after somebody else's terminal got it.
  const FileDescriptor master(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
  ASSERT_EQ(::unlockpt(master.get()), 0);
  for (const std::string& target : {std::string("/dev/pts/999999"), std::string(::ptsname(master.get()))}) {
    std::filesystem::create_symlink(target, link);
    const PseudoTerminal terminal(link);
    EXPECT_EQ(std::filesystem::read_symlink(link), terminal.path());
  }
}

TEST(PseudoTerminalTest, LeavesALinkThatIsNoLongerItsOwn) {
  const std::filesystem::path link = temporary("_taken");
  {
    PseudoTerminal first(link);
    first.unplug();
    const PseudoTerminal second(link);
    EXPECT_THROW(first.plug(), SensorFault);
    EXPECT_EQ(std::filesystem::read_symlink(link), second.path());
  }
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(link)));
}

TEST(PseudoTerminalTest, UnpluggingEndsTheOtherSide) {
  const std::filesystem::path link = temporary("_unplug");
  PseudoTerminal terminal(link);
  SerialPort port(link.string());
  terminal.unplug();
  const StopSignal stop;
  std::array<std::uint8_t, 8> buffer{};
  EXPECT_THROW(port.read(buffer, 1.0, stop), SensorFault);
  EXPECT_THROW(port.write(Bytes{1}, stop), SensorFault);
  EXPECT_FALSE(std::filesystem::exists(link));
  terminal.plug();
  EXPECT_NO_THROW(SerialPort(link.string()));
}

}  // namespace
}  // namespace scanbed::hw
