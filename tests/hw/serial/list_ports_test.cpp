// SPDX-License-Identifier: MIT
#include "hw/serial/list_ports.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace scanbed::hw {
namespace {

namespace fs = std::filesystem;

class ListPortsTest : public ::testing::Test {
 protected:
  ListPortsTest() : root_(fs::path(::testing::TempDir()) / ("ports_" + std::to_string(::getpid()))) {
    fs::create_directories(root_ / "dev" / "serial" / "by-id");
    fs::create_directories(root_ / "sys" / "class" / "tty");
    root_ = fs::canonical(root_);
  }
  ~ListPortsTest() override { fs::remove_all(root_); }

  void add(const std::string& name) const { std::ofstream(root_ / "dev" / name) << ""; }
  void add_type(const std::string& name, int type) const {
    fs::create_directories(root_ / "sys" / "class" / "tty" / name);
    std::ofstream(root_ / "sys" / "class" / "tty" / name / "type") << type << "\n";
  }
  std::vector<PortName> list() const { return list_ports(root_ / "dev", root_ / "sys"); }
  std::string dev(const std::string& name) const { return (root_ / "dev" / name).string(); }

  fs::path root_;
};

TEST_F(ListPortsTest, PrefersTheNameThatStays) {
  add("ttyUSB0");
  add("ttyUSB1");
  fs::create_symlink("../../ttyUSB1", root_ / "dev/serial/by-id/usb-FTDI_A1-if00-port0");
  EXPECT_EQ(list(), (std::vector<PortName>{{dev("serial/by-id/usb-FTDI_A1-if00-port0"), dev("ttyUSB1")},
                                           {dev("ttyUSB0"), dev("ttyUSB0")}}));
}

TEST_F(ListPortsTest, LeavesOutPortsWithoutAChipAndWhatIsNone) {
  for (const char* name : {"ttyS0", "ttyS1", "tty1", "null"}) add(name);
  add_type("ttyS0", 4);
  add_type("ttyS1", 0);
  EXPECT_EQ(list(), (std::vector<PortName>{{dev("ttyS0"), dev("ttyS0")}}));
}

TEST_F(ListPortsTest, LeavesOutLinksToNothing) {
  fs::create_symlink("../../ttyUSB9", root_ / "dev/serial/by-id/usb-gone");
  EXPECT_TRUE(list().empty());
}

TEST(ListPortsWithoutFoldersTest, IsEmpty) {
  EXPECT_TRUE(list_ports("/no/such/dev", "/no/such/sys").empty());
}

}  // namespace
}  // namespace scanbed::hw
