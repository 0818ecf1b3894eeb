// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hw/sick/lms_configuration.hpp"
#include "hw/sick/lms_variant.hpp"

namespace scanbed::hw {

/// What can go wrong with a sensor, its cable and its port.
enum class LmsFaultKind {
  kGarbage,    ///< bytes that nobody sent, before the next telegram of the stream
  kHalf,       ///< the next telegram of the stream breaks off in the middle
  kFlip,       ///< one bit of the next telegram of the stream is flipped
  kBlindPair,  ///< two bits are flipped that the check word cannot notice, in command, count or unit
  kNak,        ///< the next request is answered with NAK
  kMiss,       ///< the next request is not heard
  kRefuse,     ///< the next change of mode is refused
  kSilence,    ///< nothing is sent nor heard for a while, then all goes on as before
  kReboot,     ///< the sensor starts anew, at the baud of power-on
  kUnplug,     ///< the port goes away for a while
  kPollution,  ///< the window is dirty for the next ten scans
};

struct LmsFault {
  LmsFaultKind kind = LmsFaultKind::kGarbage;
  double at_s = 0.0;  ///< after the emulator's start
};

/// "garbage", "half", "flip", "blind_pair", "nak", "miss", "refuse", "silence", "reboot", "unplug",
/// "pollution".
std::string_view to_string(LmsFaultKind kind);

/// Parses "reboot@12.5".
/// @throws InputError naming what was wrong and the names there are.
LmsFault parse_lms_fault(std::string_view text);

/// An emulated sensor as it comes out of its box, and how it behaves.
struct EmulatorOptions {
  std::uint8_t address = 0;  ///< its own, at most 127; real sensors have 0 or 1
  int power_on_baud = 9600;  ///< also after a reboot
  LmsVariant variant;
  LmsConfiguration configuration;
  std::string type = "LMS200;301063;V02.10 ";
  bool is_paced = true;         ///< false: no delay anywhere, and scans as fast as the host takes them
  double boot_s = 2.0;          ///< from power-on to the first telegram
  double mode_switch_s = 0.05;  ///< from a change of mode to its reply
  double write_s = 0.15;        ///< from writing the configuration to its reply
  double silence_s = 3.0;       ///< length of kSilence
  double unplug_s = 1.5;        ///< length of kUnplug
  std::uint64_t seed = 1;       ///< of what the faults leave to chance
  std::vector<LmsFault> faults;

  void validate() const;  ///< @throws InputError naming the first field out of range
};

}  // namespace scanbed::hw
