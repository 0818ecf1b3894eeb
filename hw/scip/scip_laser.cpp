// SPDX-License-Identifier: MIT
#include "hw/scip/scip_laser.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/errors/input_error.hpp"
#include "hw/serial/serial_port.hpp"
#include "hw/serial/steady_clock.hpp"
#include "hw/serial/tcp_link.hpp"

namespace scanbed::hw {
namespace {

constexpr int kSyncTries = 4;
constexpr int kMostDamaged = 5;
constexpr double kLeave_s = 0.15;       // for an answer: whoever stops does not want to wait
constexpr double kBaudPause_s = 0.15;   // that a sensor takes to change it
constexpr std::size_t kHeadLines = 3;   // echo, status, time
constexpr std::size_t kEchoChars = 13;  // of an MD command, without the number of scans, which counts down
constexpr std::array<int, 7> kBauds = {19200, 38400, 57600, 115200, 250000, 500000, 750000};
constexpr const char* kAbnormal = "0L";

std::unique_ptr<ByteLink> open_link(const ScipOptions& options, const StopSignal& stop) {
  if (!options.path.empty()) return std::make_unique<SerialPort>(options.path);
  return std::make_unique<TcpLink>(options.host, options.port, options.connect_s, stop);
}

/// A port that cannot do this baud has no sensor at it.
bool may_be_at(ScipClient& client, int baud) {
  try {
    return client.synchronise_at(baud);
  } catch (const UnsupportedBaud&) {
    return false;
  }
}

/// Finds the baud of a serial sensor, and gives it; a network has none.
int find_sensor(const ScipOptions& options, ScipClient& client) {
  if (client.synchronise_at(options.baud)) return options.baud;
  for (const int baud : kBauds) {
    const bool is_new = !options.path.empty() && baud != options.baud;
    if (is_new && may_be_at(client, baud)) return baud;
  }
  if (client.last_status().empty()) {
    throw SensorFault(SensorFault::Kind::kTimeout,
                      options.name() + ": no SCIP sensor answers; is it on, and is this its port?");
  }
  throw SensorFault(SensorFault::Kind::kProtocol,
                    options.name() + ": the sensor answers QT with status " + client.last_status() +
                        (client.last_status() == kAbnormal ? " (abnormal), also after a reset" : ""));
}

ScipParameters read_parameters(const ScipOptions& options, ScipClient& client) {
  const auto parameters = parse_scip_parameters(client.ask("PP"));
  if (parameters) return *parameters;
  throw SensorFault(SensorFault::Kind::kProtocol, options.name() + ": its parameters (PP) make no sense");
}

/// Of a message on the wire.
std::size_t num_bytes(const std::vector<std::string>& lines) {
  std::size_t num_bytes = 1;  // the empty line at the end
  for (const std::string& line : lines) num_bytes += line.size() + 1;
  return num_bytes;
}

void stream(ScipClient& client, const ScipParameters& parameters, const RecoveringLaser::Give& give) {
  ScipScans scans(parameters);
  const std::string status = scip_status(client.ask(scans.command()));
  if (status != "00") {
    throw SensorFault(SensorFault::Kind::kProtocol,
                      "the sensor refused " + scans.command() + ": status " + status);
  }
  const double silence_s = std::max(1.0, 16.0 * parameters.scan_period_s());
  std::vector<std::string> lines;
  LaserScan scan;
  for (int num_damaged = 0; num_damaged < kMostDamaged;) {
    if (!client.next_message(lines, silence_s)) {
      throw SensorFault(SensorFault::Kind::kTimeout, "the stream fell silent");
    }
    const ScipScans::Outcome outcome = scans.take(lines, client.sent_s(), scan);
    if (outcome == ScipScans::Outcome::kFault) {
      throw SensorFault(SensorFault::Kind::kProtocol, "the sensor stopped: status " + scip_status(lines));
    }
    num_damaged = outcome == ScipScans::Outcome::kDamaged ? num_damaged + 1 : 0;
    if (outcome == ScipScans::Outcome::kScan) give(scan);
  }
  throw SensorFault(SensorFault::Kind::kProtocol, "nothing but damaged scans");
}

/// Leaves the sensor quiet, as far as it still listens. Waits for its answer, since what is closed at once
/// may never be read.
void leave(ByteLink& link) noexcept {
  try {
    const StopSignal not_given;
    ScipClient(link, kLeave_s, not_given).ask("QT");
  } catch (const std::exception&) {
    return;
  }
}

void attempt(const ScipOptions& options, const RecoveringLaser::Give& give, const StopSignal& stop) {
  const std::unique_ptr<ByteLink> link = open_link(options, stop);
  ScipClient client(*link, options.reply_s, stop);
  try {
    const int found_baud = find_sensor(options, client);
    if (found_baud != options.baud) client.change_baud(found_baud, options.baud);
    stream(client, read_parameters(options, client), give);
  } catch (...) {
    leave(*link);
    throw;
  }
}

}  // namespace

void ScipOptions::validate() const {
  if (path.empty() && host.empty())
    throw InputError("scip: no port; write scip:/dev/ttyACM0 or scip:HOST:10940");
  require(port > 0 && port <= 65535, "scip.port", port, "[1, 65535]");
  require(baud > 0 && baud <= 4000000, "scip.baud", baud, "[1, 4000000]");
}

std::string scip_status(std::span<const std::string> lines) {
  if (lines.size() < 2) return "";
  const auto body = strip_sum(lines[1]);
  return body && body->size() == 2 ? std::string(*body) : "";
}

ScipClient::ScipClient(ByteLink& link, double reply_s, const StopSignal& stop)
    : link_(link), reply_s_(reply_s), stop_(stop) {}

void ScipClient::send(const std::string& command) {
  const std::string line = command + "\n";
  link_.write({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()}, stop_);
}

bool ScipClient::next_message(std::vector<std::string>& lines, double timeout_s) {
  const double deadline_s = steady_now_s() + timeout_s;
  std::array<std::uint8_t, 4096> buffer{};
  while (!reader_.next(lines)) {
    const double left_s = deadline_s - steady_now_s();
    if (left_s < 0.0) return false;
    const std::size_t count = link_.read(buffer, left_s, stop_);
    reader_.feed({reinterpret_cast<const char*>(buffer.data()), count});
  }
  const double now_s = steady_now_s();
  const double wire_s = static_cast<double>(num_bytes(lines)) * link_.byte_s();
  sent_s_ = now_s - std::min(wire_s, now_s - read_s_);
  read_s_ = now_s;
  return true;
}

std::vector<std::string> ScipClient::ask(const std::string& command) {
  send(command);
  const double deadline_s = steady_now_s() + reply_s_;
  std::vector<std::string> lines;
  while (next_message(lines, std::max(0.0, deadline_s - steady_now_s()))) {
    // The end of a message cut off may stand before the echo.
    const auto echo = std::find(lines.begin(), lines.end(), command);
    if (echo != lines.end()) return {echo, lines.end()};
    if (steady_now_s() > deadline_s) break;
  }
  throw SensorFault(SensorFault::Kind::kTimeout, "no answer to " + command);
}

/// Asks for quiet, and where the sensor is not in SCIP 2's ordinary mode, asks it to go there.
/// @returns whether it is quiet and there.
bool ScipClient::quieten() {
  const std::vector<std::string> reply = ask("QT");
  const std::string status = scip_status(reply);
  if (!status.empty()) last_status_ = status;
  // SCIP 1.1 has one character without a sum; 0E comes while the clock is being set.
  if (reply.size() > 1 && reply[1] == "E") ask("SCIP2.0");
  if (status == "0E") ask("TM2");
  if (status == kAbnormal) ask("RS");
  return status == "00";
}

bool ScipClient::synchronise() {
  reader_.clear();
  for (int i = 0; i < kSyncTries; ++i) {
    try {
      if (quieten()) return true;
    } catch (const SensorFault& fault) {
      if (fault.kind() != SensorFault::Kind::kTimeout) throw;
      reader_.clear();
      if (i >= 1) return false;
    }
  }
  return false;
}

bool ScipClient::synchronise_at(int baud) {
  link_.set_baud(baud);
  return synchronise();
}

void ScipClient::change_baud(int baud, int wanted_baud) {
  // What the port cannot do shows before the sensor is asked to.
  link_.set_baud(wanted_baud);
  link_.set_baud(baud);
  std::array<char, 16> command{};
  std::snprintf(command.data(), command.size(), "SS%06d", wanted_baud);
  if (scip_status(ask(command.data())) != "00") return;
  stop_.sleep(kBaudPause_s);
  if (synchronise_at(wanted_baud) || synchronise_at(baud)) return;
  throw SensorFault(SensorFault::Kind::kTimeout, std::string("the sensor is lost after ") + command.data());
}

ScipScans::ScipScans(const ScipParameters& parameters)
    : parameters_(parameters), geometry_(parameters.geometry()) {}

std::string ScipScans::command() const {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "MD%04d%04d01000", parameters_.first_step, parameters_.last_step);
  return text.data();
}

bool ScipScans::read_ranges(const std::string& data, LaserScan& scan) const {
  const auto num_beams = static_cast<std::size_t>(parameters_.num_beams());
  if (data.size() != 3 * num_beams) return false;
  scan.range_m.resize(num_beams);
  for (std::size_t i = 0; i < num_beams; ++i) {
    const auto range_mm = decode_scip(std::string_view(data).substr(3 * i, 3));
    if (!range_mm) return false;
    const bool is_range = *range_mm >= parameters_.min_range_mm && *range_mm <= parameters_.max_range_mm;
    scan.range_m[i] = is_range ? static_cast<double>(*range_mm) / 1000.0 : kNoEcho;
  }
  return true;
}

ScipScans::Outcome ScipScans::take(const std::vector<std::string>& message, double sent_s, LaserScan& scan) {
  if (message.empty()) return Outcome::kOther;
  const std::string echo = command().substr(0, kEchoChars);
  // The end of a message cut off may stand before the echo.
  const auto begin = std::find_if(message.begin(), message.end(),
                                  [&](const std::string& line) { return line.starts_with(echo); });
  if (begin == message.end()) return Outcome::kDamaged;
  const std::span<const std::string> lines(begin, message.end());
  const std::string status = scip_status(lines);
  if (status == "00") return Outcome::kOther;
  if (status.empty()) return Outcome::kDamaged;
  if (status != "99") return Outcome::kFault;
  if (lines.size() <= kHeadLines) return Outcome::kDamaged;
  const auto time_text = strip_sum(lines[2]);
  const auto stamp = time_text && time_text->size() == 4 ? decode_scip(*time_text) : std::nullopt;
  const auto data = join_scip_blocks({lines.begin() + kHeadLines, lines.end()});
  if (!stamp || !data || !read_ranges(*data, scan)) return Outcome::kDamaged;
  const double step_s = geometry_.timing.step_s;
  scan.time_s =
      clock_.to_local_s(*stamp, sent_s - parameters_.last_step * step_s) + parameters_.first_step * step_s;
  scan.geometry = geometry_;
  scan.X_OR.reset();
  scan.source.clear();
  scan.health = {};
  return Outcome::kScan;
}

std::unique_ptr<RangeSensor> open_scip(const ScipOptions& options) {
  options.validate();
  return std::make_unique<RecoveringLaser>(
      options.name(), options.recovery,
      [options](const RecoveringLaser::Give& give, const StopSignal& stop) { attempt(options, give, stop); });
}

}  // namespace scanbed::hw
