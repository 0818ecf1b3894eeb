// SPDX-License-Identifier: MIT
#include "hw/sick/emulator_options.hpp"

#include <gtest/gtest.h>

#include "core/errors/input_error.hpp"

namespace scanbed::hw {
namespace {

TEST(EmulatorOptionsTest, DefaultsValidate) {
  EXPECT_NO_THROW(EmulatorOptions{}.validate());
}

TEST(EmulatorOptionsTest, NamesTheFieldThatIsWrong) {
  const auto message = [](const EmulatorOptions& options) -> std::string {
    try {
      options.validate();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message({.address = 128}).find("emulator.address"), std::string::npos);
  EXPECT_NE(message({.power_on_baud = 115200}).find("emulator.power_on_baud"), std::string::npos);
  EXPECT_NE(message({.variant = {180, 25}}).find("emulator.variant"), std::string::npos);
  EXPECT_NE(message({.boot_s = -1.0}).find("emulator.boot_s"), std::string::npos);
  EXPECT_NE(message({.mode_switch_s = 4.0}).find("emulator.mode_switch_s"), std::string::npos);
  EXPECT_NE(message({.write_s = 26.0}).find("emulator.write_s"), std::string::npos);
  EXPECT_NE(message({.silence_s = -1.0}).find("emulator.silence_s"), std::string::npos);
  EXPECT_NE(message({.unplug_s = -1.0}).find("emulator.unplug_s"), std::string::npos);
}

TEST(EmulatorOptionsTest, FaultsHaveNamesAndTimes) {
  for (const char* name : {"garbage", "half", "flip", "blind_pair", "nak", "miss", "refuse", "silence",
                           "reboot", "unplug", "pollution"}) {
    const LmsFault fault = parse_lms_fault(std::string(name) + "@12.5");
    EXPECT_EQ(to_string(fault.kind), name);
    EXPECT_EQ(fault.at_s, 12.5);
  }
}

TEST(EmulatorOptionsTest, RefusesFaultsThatAreNone) {
  for (const char* text :
       {"", "fire@1", "reboot", "reboot@", "reboot@x", "reboot@-1", "reboot@1s", "reboot@inf"}) {
    EXPECT_THROW(parse_lms_fault(text), InputError) << text;
  }
}

}  // namespace
}  // namespace scanbed::hw
