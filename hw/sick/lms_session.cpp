// SPDX-License-Identifier: MIT
#include "hw/sick/lms_session.hpp"

#include <optional>
#include <string>

#include "hw/serial/steady_clock.hpp"

namespace scanbed::hw {
namespace {

constexpr int kTriesAtABaud = 2;
// Type and errors are at hand at once, unlike a change of mode.
constexpr double kDiagnosticReply_s = 1.0;

void check_done(const ModeReply& reply, const std::string& what) {
  if (reply.result == 0) return;
  throw DeviceRefusal("the sensor refused " + what + " (result " + std::to_string(reply.result) +
                      (reply.result == 1 ? ": wrong password or not allowed)" : ": fault)"));
}

std::string text_of(const LmsVariant& variant) {
  return std::to_string(variant.fov_deg) + " degrees at " + std::to_string(variant.resolution_cdeg) +
         " hundredths of a degree";
}

void set_mode(LmsLink& link, LmsMode mode, const std::string& what) {
  check_done(link.ask<ModeReply>(SetModeCommand{mode}), what);
}

bool answers(LmsLink& link) {
  try {
    link.ask<ModeReply>(SetModeCommand{LmsMode::kOnRequest}, {.num_tries = kTriesAtABaud});
    return true;
  } catch (const LmsReboot&) {
    return true;  // it speaks, and it is in the mode that was asked for
  } catch (const DeviceRefusal&) {
    return true;
  } catch (const SensorFault& fault) {
    if (fault.kind() != SensorFault::Kind::kTimeout) throw;
    return false;
  }
}

/// Answer to a request that a sensor may not know; what is not needed to stream is not insisted on.
template <typename Reply>
Reply ask_if_known(LmsLink& link, RequestCommand::What what) {
  try {
    return link.ask<Reply>(RequestCommand{what}, {.num_tries = kTriesAtABaud, .reply_s = kDiagnosticReply_s});
  } catch (const LmsReboot&) {
    throw;
  } catch (const DeviceRefusal&) {
    return {};
  } catch (const SensorFault& fault) {
    if (fault.kind() != SensorFault::Kind::kTimeout) throw;
    return {};
  }
}

LmsIdentity identify(LmsLink& link, int baud) {
  LmsIdentity identity;
  identity.found_baud = baud;
  identity.status = link.ask<StatusReply>(RequestCommand{RequestCommand::What::kStatus});
  identity.type = ask_if_known<TypeReply>(link, RequestCommand::What::kType).text;
  identity.errors = ask_if_known<ErrorsReply>(link, RequestCommand::What::kErrors).entries;
  return identity;
}

void set_variant(LmsLink& link, const LmsVariant& now, const LmsVariant& wanted) {
  if (now == wanted) return;
  const auto reply = link.ask<VariantReply>(SetVariantCommand{wanted});
  if (reply.is_done && reply.variant == wanted) return;
  throw DeviceRefusal("the sensor refused " + text_of(wanted) + " and stays at " + text_of(reply.variant) +
                      "; choose another fov_deg or resolution_deg");
}

LmsConfiguration wanted_configuration(const LmsConfiguration& now, const SickOptions& options) {
  LmsConfiguration wanted = now;
  wanted.set_unit(options.unit);
  if (options.measuring_mode) {
    wanted.set_measuring_mode(static_cast<std::uint8_t>(*options.measuring_mode));
  } else if (!lms_word_format(now.measuring_mode())) {
    wanted.set_measuring_mode(0);
  }
  return wanted;
}

LmsConfiguration read_configuration(LmsLink& link) {
  return link.ask<ConfigurationReply>(RequestCommand{RequestCommand::What::kConfiguration}).configuration;
}

/// Whether a configuration is the wanted one in what the driver depends on. A sensor may set other bytes its
/// own way; to write again because of them would wear the EEPROM for nothing.
bool serves(const LmsConfiguration& configuration, const LmsConfiguration& wanted) {
  return configuration.unit() == wanted.unit() && configuration.measuring_mode() == wanted.measuring_mode();
}

/// Writes once. An answer that got lost is no reason to write again: what is in force is read instead.
/// @returns the configuration in force.
LmsConfiguration write_once(LmsLink& link, const LmsConfiguration& wanted) {
  const double write_s = link.patience().write_s;
  try {
    const auto reply = link.ask<WrittenReply>(WriteConfigurationCommand{wanted},
                                              {.num_tries = 1, .first_sign_s = write_s, .reply_s = write_s});
    if (reply.is_done && serves(reply.configuration, wanted)) return reply.configuration;
  } catch (const LmsReboot&) {
    throw;
  } catch (const DeviceRefusal&) {
    throw;
  } catch (const SensorFault& fault) {
    if (fault.kind() != SensorFault::Kind::kTimeout) throw;
    LmsConfiguration now = read_configuration(link);
    if (serves(now, wanted)) return now;
    throw;
  }
  throw DeviceRefusal("the sensor refused the configuration (unit or measuring mode)");
}

LmsConfiguration write_configuration(LmsLink& link, const LmsConfiguration& wanted) {
  std::optional<LmsConfiguration> in_force;
  try {
    check_done(link.ask<ModeReply>(SetModeCommand{LmsMode::kInstallation, true}), "the installation mode");
    in_force = write_once(link, wanted);
  } catch (const SensorFault&) {
    link.tell(SetModeCommand{LmsMode::kOnRequest});
    throw;
  }
  set_mode(link, LmsMode::kOnRequest, "to leave the installation mode");
  return *in_force;
}

/// The variant of the sensor that carries what the options ask for: four turns a scan are those of 0.25
/// degrees, which the sensor offers at 100 degrees; turns are sent 180 degrees wide all the same.
LmsVariant sensor_variant(const SickOptions& options) {
  return options.is_interlaced_here() ? LmsVariant{100, 25} : options.variant();
}

}  // namespace

std::vector<int> probe_order(int first_baud) {
  std::vector<int> bauds{first_baud};
  for (const int baud : {9600, 38400, 19200, 500000}) {
    if (baud != first_baud) bauds.push_back(baud);
  }
  return bauds;
}

LmsIdentity find_lms(LmsLink& link, std::span<const int> bauds) {
  for (const int baud : bauds) {
    try {
      link.set_baud(baud);
    } catch (const UnsupportedBaud&) {
      continue;  // plain RS-232 cannot do 500000
    }
    if (answers(link)) return identify(link, baud);
  }
  throw SensorFault(SensorFault::Kind::kTimeout,
                    "nothing answers at " + std::string(kLmsBaudNames) +
                        " baud; is the sensor on (it starts up to 60 s), is the cable the right one (RS-232 "
                        "or RS-422, null modem), is this its port?");
}

void change_baud(LmsLink& link, int baud) {
  check_done(link.ask<ModeReply>(SetBaudCommand{baud}), std::to_string(baud) + " baud");
  link.set_baud(baud);
  link.stop().sleep(link.patience().settle_s);
  link.ask<StatusReply>(RequestCommand{RequestCommand::What::kStatus});
}

LmsConfiguration start_stream(LmsLink& link, const LmsIdentity& identity, const SickOptions& options) {
  if (identity.found_baud != options.baud) change_baud(link, options.baud);
  set_variant(link, identity.status.variant, sensor_variant(options));
  LmsConfiguration now = read_configuration(link);
  const LmsConfiguration wanted = wanted_configuration(now, options);
  if (!(wanted == now)) now = write_configuration(link, wanted);
  set_mode(link, options.is_interlaced_here() ? LmsMode::kStreamPartial : LmsMode::kStream, "to stream");
  return now;
}

void end_stream(ByteLink& port, int baud, double answer_s) noexcept {
  try {
    const StopSignal not_given;
    LmsLink link(port, {.ack_s = answer_s, .reply_s = answer_s}, not_given);
    const LmsLink::Ask twice{.num_tries = 2};
    bool is_quiet = true;
    try {
      link.ask<ModeReply>(SetModeCommand{LmsMode::kOnRequest}, twice);
    } catch (const SensorFault&) {
      is_quiet = false;
    }
    // Also to a sensor that is slow to answer: it may hear it yet.
    const LmsLink::Ask briefly{.num_tries = 1, .first_sign_s = answer_s / 2, .reply_s = answer_s / 2};
    if (baud != 0) link.ask<ModeReply>(SetBaudCommand{baud}, is_quiet ? twice : briefly);
  } catch (const Stopped&) {
    return;
  } catch (const std::exception&) {
    // A sensor that does not listen keeps its baud: the next driver looks for it there, and stops its stream.
    return;
  }
}

}  // namespace scanbed::hw
