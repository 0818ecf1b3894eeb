// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "hw/serial/bytes.hpp"
#include "hw/sick/lms_configuration.hpp"
#include "hw/sick/lms_variant.hpp"

namespace scanbed::hw {

// What a host says to an LMS 2xx. Each type is one command with its data.

struct ResetCommand {};  ///< 10h

enum class LmsMode : std::uint8_t {
  kInstallation = 0x00,   ///< with the password; the only mode that takes a configuration
  kDiagnostic = 0x10,     ///< listed; what an LMS measures then was not at hand
  kStream = 0x24,         ///< all values, scan after scan
  kOnRequest = 0x25,      ///< values when 30h asks; so after power-on
  kStreamPartial = 0x2A,  ///< each turn of the mirror as its own telegram
  kTest = 0x30,           ///< with the password
};

/// 20h with a mode.
struct SetModeCommand {
  LmsMode mode = LmsMode::kOnRequest;
  bool has_password = false;  ///< the factory's "SICK_LMS" follows; only kInstallation and kTest need it
};

struct SetBaudCommand {  ///< 20h with 40h, 41h, 42h or 48h
  int baud = 9600;
};

struct StreamSubrangeCommand {  ///< 20h 27h: values `first` to `last`, counted from 1
  int first = 1;
  int last = 361;
};

struct RequestScanCommand {  ///< 30h
  enum class What : std::uint8_t { kWhole = 0x01, kPartials = 0x08 };
  What what = What::kWhole;
};

/// Commands that are one byte.
struct RequestCommand {
  enum class What : std::uint8_t {
    kStatus = 0x31,
    kErrors = 0x32,
    kType = 0x3A,
    kConfiguration = 0x74,
    kOther = 0x7B,  ///< listed, but what it answers was not at hand
  };
  What what = What::kStatus;
};

struct SetVariantCommand {  ///< 3Bh
  LmsVariant variant;
};

struct SetPermanentBaudCommand {  ///< 66h: whether the baud now set is also that after power-on
  bool is_permanent = false;
};

struct WriteConfigurationCommand {  ///< 77h: burns the EEPROM, which stands some thousands of times
  LmsConfiguration configuration;
};

using LmsCommand =
    std::variant<ResetCommand, SetModeCommand, SetBaudCommand, StreamSubrangeCommand, RequestScanCommand,
                 RequestCommand, SetVariantCommand, SetPermanentBaudCommand, WriteConfigurationCommand>;

/// Body of the command's telegram.
///
/// @pre  a baud is one that the LMS knows. Checked; aborts.
/// @par Source  SICK, "Telegrams for Configuring and Operating the LMS 2xx", commands by number.
Bytes encode(const LmsCommand& command);

/// The command that a body holds; empty where it holds none of them. A wrong password reads as none given.
std::optional<LmsCommand> parse_command(ByteView body);

}  // namespace scanbed::hw
