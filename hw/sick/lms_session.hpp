// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "hw/sick/lms_link.hpp"
#include "hw/sick/sick_options.hpp"

namespace scanbed::hw {

/// What a sensor turned out to be.
struct LmsIdentity {
  int found_baud = 0;  ///< at which it answered first
  std::string type;    ///< "LMS200;301063;V02.10 "; empty where it does not say
  StatusReply status;
  std::vector<ErrorsReply::Entry> errors;  ///< empty also where it does not say
};

/// Bauds in the order in which to try them: the wanted one, then the likeliest.
std::vector<int> probe_order(int first_baud);

/// Looks for the sensor at each baud, and stops its stream. The port is left at the baud that it answered at.
///
/// @throws SensorFault kTimeout where nothing answers at any of them, saying what to check.
LmsIdentity find_lms(LmsLink& link, std::span<const int> bauds);

/// Takes sensor and port to another baud, and sees that they understand each other there.
/// @throws DeviceRefusal, SensorFault kTimeout.
void change_baud(LmsLink& link, int baud);

/// Brings a sensor that was found to where it streams what the options say: baud, variant, configuration,
/// mode. The configuration is read first and written only where it differs, since it wears the EEPROM; the
/// mode in which it can be written is left again whatever happens.
///
/// @returns the configuration in force.
/// @throws DeviceRefusal saying what the sensor does not take; SensorFault as ask() does.
LmsConfiguration start_stream(LmsLink& link, const LmsIdentity& identity, const SickOptions& options);

/// Stops the stream and then, where `baud` is not 0, goes back to it. Asks twice for either, and waits at
/// most `answer_s` each time, whether the sensor listens or not. @throws nothing.
void end_stream(ByteLink& port, int baud, double answer_s) noexcept;

}  // namespace scanbed::hw
