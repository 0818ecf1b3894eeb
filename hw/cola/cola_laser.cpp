// SPDX-License-Identifier: MIT
#include "hw/cola/cola_laser.hpp"

#include <algorithm>
#include <array>

#include "core/errors/input_error.hpp"
#include "hw/cola/cola_scan.hpp"
#include "hw/serial/device_clock.hpp"
#include "hw/serial/steady_clock.hpp"
#include "hw/serial/tcp_link.hpp"

namespace scanbed::hw {
namespace {

constexpr const char* kClientPassword = "F4724744";
constexpr int kMostDamaged = 5;
constexpr double kLeave_s = 0.15;  // for an answer: whoever stops does not want to wait
constexpr std::uint32_t kMeasuring = 7;

bool is_error(const std::string& answer) {
  return answer.starts_with("sFA");
}

std::uint32_t error_code(const std::string& answer) {
  ColaTokens tokens(answer);
  tokens.next();
  return tokens.next_hex().value_or(6);
}

/// Whether an error says that the sensor does not know or not allow what was asked. All others may pass: it
/// is busy, or this is the answer to a client that was here before and is gone.
bool is_lasting_error(const std::string& answer) {
  constexpr std::array<std::uint32_t, 7> kLasting = {0x1, 0x2, 0x3, 0xA, 0xB, 0xC, 0xF};
  return is_error(answer) && std::ranges::count(kLasting, error_code(answer)) > 0;
}

/// @throws DeviceRefusal where the error lasts, or SensorFault, after which another attempt may succeed.
[[noreturn]] void refuse(const std::string& what, const std::string& answer) {
  const std::string text = "the sensor refused " + what + ": " + cola_error_text(error_code(answer));
  if (is_lasting_error(answer)) throw DeviceRefusal(text);
  throw SensorFault(SensorFault::Kind::kProtocol, text);
}

/// The number at the end of an answer such as "sAN SetAccessMode 1".
std::uint32_t result_of(const std::string& answer, std::uint32_t if_none) {
  ColaTokens tokens(answer);
  tokens.next();
  tokens.next();
  return tokens.next_hex().value_or(if_none);
}

/// False where the sensor does not let anybody in.
bool log_in(ColaClient& client) {
  const std::string answer = client.ask(std::string("sMN SetAccessMode 03 ") + kClientPassword);
  if (is_error(answer) && !is_lasting_error(answer)) refuse("the log-in", answer);
  return !is_error(answer) && result_of(answer, 0) == 1;
}

/// Asks until the sensor has time for it; whether it can do it is another matter.
void carry_out(ColaClient& client, const std::string& request, const ColaOptions& options,
               const StopSignal& stop) {
  constexpr std::uint32_t kBusy = 0xD;
  const double deadline_s = steady_now_s() + options.spin_up_s;
  while (true) {
    const std::string answer = client.ask(request);
    if (!is_error(answer) || error_code(answer) != kBusy) return;
    if (steady_now_s() > deadline_s) refuse(request, answer);
    stop.sleep(options.poll_s);
  }
}

/// An LMS tells when its motor is up; a TiM does not know the question and scans by itself.
bool measures(ColaClient& client) {
  const std::string answer = client.ask("sRN STlms");
  if (is_error(answer)) return is_lasting_error(answer);
  return result_of(answer, kMeasuring) == kMeasuring;
}

/// Waits also where the log-in was refused: after power-on the motor starts by itself.
void wait_for_motor(ColaClient& client, bool is_logged_in, const ColaOptions& options,
                    const StopSignal& stop) {
  const double deadline_s = steady_now_s() + options.spin_up_s;
  while (!measures(client)) {
    if (steady_now_s() > deadline_s && !is_logged_in) {
      throw DeviceRefusal(
          "the sensor does not measure, and refused the log-in as authorised client; was its password "
          "changed?");
    }
    if (steady_now_s() > deadline_s) {
      throw SensorFault(SensorFault::Kind::kTimeout, "the sensor does not begin to measure");
    }
    stop.sleep(options.poll_s);
  }
}

/// @param must_run  set as long as the sensor is logged in, and so sends nothing to anybody.
void start(ColaClient& client, const ColaOptions& options, const StopSignal& stop, bool& must_run) {
  client.ask("sEN LMDscandata 0");  // of a client that was here before
  // Newer firmware may refuse the log-in, and sensors that measure already stream without it.
  must_run = true;
  const bool is_logged_in = log_in(client);
  if (is_logged_in) {
    // Distances of the first echo alone. Sensors that fix this refuse it; what they send is taken as it
    // comes.
    carry_out(client, "sWN LMDscandatacfg 01 00 0 0 0 00 00 0 0 0 0 +1", options, stop);
    carry_out(client, "sMN LMCstartmeas", options, stop);
    carry_out(client, "sMN Run", options, stop);
  }
  must_run = false;
  wait_for_motor(client, is_logged_in, options, stop);
  const std::string answer = client.ask("sEN LMDscandata 1");
  if (is_error(answer)) refuse("to stream", answer);
}

void stream(ColaClient& client, const RecoveringLaser::Give& give) {
  DeviceClock clock(32, 1e-6);
  double silence_s = 2.0;
  std::string body;
  LaserScan scan;
  for (int num_damaged = 0; num_damaged < kMostDamaged;) {
    if (!client.next_scan(body, silence_s)) {
      throw SensorFault(SensorFault::Kind::kTimeout, "the stream fell silent");
    }
    const auto telegram = parse_cola_scan(body);
    if (!telegram || !to_laser_scan(*telegram, scan)) {
      ++num_damaged;
      continue;
    }
    num_damaged = 0;
    // It cannot have arrived before it was sent.
    scan.time_s = clock.to_local_s(telegram->start_us, steady_now_s() - telegram->age_s());
    if (telegram->frequency_chz > 0) silence_s = 1.0 + 3.0 * std::min(10.0, 100.0 / telegram->frequency_chz);
    give(scan);
  }
  throw SensorFault(SensorFault::Kind::kProtocol, "nothing but damaged scans");
}

/// Leaves the sensor quiet and logged out, as far as it still listens. Waits for its answers, since what is
/// closed at once may never be read.
void leave(ByteLink& link, bool must_run) noexcept {
  try {
    const StopSignal not_given;
    ColaClient client(link, kLeave_s, not_given);
    if (must_run) client.send("sMN Run");
    client.ask("sEN LMDscandata 0");
  } catch (const std::exception&) {
    return;
  }
}

void attempt(const ColaOptions& options, const RecoveringLaser::Give& give, const StopSignal& stop) {
  TcpLink link(options.host, options.port, options.connect_s, stop);
  ColaClient client(link, options.reply_s, stop);
  bool must_run = false;
  try {
    start(client, options, stop, must_run);
    stream(client, give);
  } catch (...) {
    leave(link, must_run);
    throw;
  }
}

}  // namespace

void ColaOptions::validate() const {
  if (host.empty()) throw InputError("cola: no host; write cola:192.168.0.1");
  require(port > 0 && port <= 65535, "cola.port", port, "[1, 65535]");
  require(poll_s > 0.0, "cola.poll_s", poll_s, "> 0");
}

ColaClient::ColaClient(ByteLink& link, double reply_s, const StopSignal& stop)
    : link_(link), reply_s_(reply_s), stop_(stop) {}

void ColaClient::send(const std::string& request) {
  link_.write(frame_cola(request), stop_);
}

bool ColaClient::next_body(std::string& body, double deadline_s) {
  std::array<std::uint8_t, 8192> buffer{};
  while (!reader_.next(body)) {
    const double left_s = deadline_s - steady_now_s();
    if (left_s < 0.0) return false;
    const std::size_t count = link_.read(buffer, left_s, stop_);
    has_heard_ = has_heard_ || count > 0;
    reader_.feed(ByteView(buffer).first(count));
    if (reader_.is_binary()) {
      throw DeviceRefusal(
          "the sensor speaks CoLa B here; set it to CoLa A, or try the other port (2111, 2112)");
    }
  }
  return true;
}

std::string ColaClient::ask(const std::string& request) {
  send(request);
  ColaTokens tokens(request);
  tokens.next();
  const std::string name(tokens.next());
  const double deadline_s = steady_now_s() + reply_s_;
  std::string body;
  while (next_body(body, deadline_s)) {
    ColaTokens answer(body);
    const std::string_view kind = answer.next();
    if (kind == "sFA") return body;
    const bool is_answer = kind == "sAN" || kind == "sRA" || kind == "sWA" || kind == "sEA";
    if (is_answer && answer.next() == name) return body;
  }
  const char* const hint =
      has_heard_ ? "" : "; does it speak CoLa A here, or is the other port (2111, 2112) meant?";
  throw SensorFault(SensorFault::Kind::kTimeout, "no answer to " + request + hint);
}

bool ColaClient::next_scan(std::string& body, double timeout_s) {
  const double deadline_s = steady_now_s() + timeout_s;
  while (next_body(body, deadline_s)) {
    if (body.starts_with("sSN LMDscandata")) return true;
  }
  return false;
}

std::unique_ptr<RangeSensor> open_cola(const ColaOptions& options) {
  options.validate();
  return std::make_unique<RecoveringLaser>(
      options.host + ":" + std::to_string(options.port), options.recovery,
      [options](const RecoveringLaser::Give& give, const StopSignal& stop) { attempt(options, give, stop); });
}

}  // namespace scanbed::hw
