// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/scan/laser_scan.hpp"
#include "hw/serial/bytes.hpp"
#include "hw/sick/lms_command.hpp"
#include "hw/sick/lms_configuration.hpp"
#include "hw/sick/lms_variant.hpp"

namespace scanbed::hw {

// What an LMS 2xx answers. Measured values (B0h) are in scan_telegram.hpp.

struct ResetReply {};  ///< 91h: the sensor starts anew, and says so with 90h when it is up

struct TypeReply {  ///< BAh, and 90h after power-on: "LMS200;301063;V02.10 "
  std::string text;
  bool is_power_on = false;
};

struct RefusedReply {};  ///< 92h: illegal command, or not in this mode

struct ModeReply {  ///< A0h: 0 is done, 1 a wrong password, 2 a fault
  std::uint8_t result = 0;
};

/// B1h: the fields that a driver needs of the sensor's long account of itself.
struct StatusReply {
  std::string firmware = "V02.10 ";  ///< 7 characters
  LmsMode mode = LmsMode::kOnRequest;
  bool is_defect = false;
  std::uint8_t sensor_variant = 0;
  int motor = 0;  ///< as it comes
  std::uint8_t measuring_mode = 0;
  LmsVariant variant;
  int baud = 9600;  ///< 0 where the code is none that the listing names
  bool has_permanent_baud = false;
  std::uint8_t address = 0;
  RangeUnit unit = RangeUnit::kMillimetre;
};

/// B2h.
struct ErrorsReply {
  struct Entry {
    std::uint8_t type = 0;    ///< severity 0 to 4; bit 7: no longer present
    std::uint8_t number = 0;  ///< 5 dazzle test, 17 to 22 pollution, 29 motor
    friend bool operator==(const Entry&, const Entry&) = default;
  };
  std::vector<Entry> entries;
};

struct VariantReply {  ///< BBh
  bool is_done = false;
  LmsVariant variant;  ///< now in force
};

struct PermanentBaudReply {  ///< E6h; what follows the command byte was not at hand, so it is not looked at
};

struct ConfigurationReply {  ///< F4h
  LmsConfiguration configuration;
};

struct WrittenReply {  ///< F7h
  bool is_done = false;
  LmsConfiguration configuration;  ///< now in force
};

using LmsReply = std::variant<ResetReply, TypeReply, RefusedReply, ModeReply, StatusReply, ErrorsReply,
                              VariantReply, PermanentBaudReply, ConfigurationReply, WrittenReply>;

/// The last byte of all that a sensor sends.
struct LmsStatusByte {
  std::uint8_t bits = 0x10;

  int severity() const { return bits & 0x07; }  ///< 0 fine, 1 note, 2 warning, 3 error, 4 fatal
  bool is_implausible() const { return (bits & 0x40) != 0; }
  bool is_polluted() const { return (bits & 0x80) != 0; }
  SensorHealth health() const { return {severity(), is_polluted(), is_implausible()}; }
};

struct StatedReply {
  LmsReply reply;
  LmsStatusByte status;
};

/// Body of the reply's telegram.
///
/// @par Source  SICK, "Telegrams for Configuring and Operating the LMS 2xx", replies by number. In B1h the
///              listing's fields sum to six bytes less than its own length; the offsets here are those that
///              drivers in use read.
Bytes encode(const LmsReply& reply, LmsStatusByte status);

/// Parses a body; empty where it is none of these replies, or has not their length.
std::optional<StatedReply> parse_reply(ByteView body);

/// The 16-bit code of a baud in B1h, and back; 0 where there is none.
unsigned baud_code(int baud);
int baud_of_code(unsigned code);

}  // namespace scanbed::hw
