// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/scan/range_sensor.hpp"
#include "hw/scip/scip_parameters.hpp"
#include "hw/scip/scip_text.hpp"
#include "hw/serial/byte_link.hpp"
#include "hw/serial/device_clock.hpp"
#include "hw/serial/recovering_laser.hpp"

namespace scanbed::hw {

/// What `scip:PORT` or `scip:HOST:PORT` says.
struct ScipOptions {
  std::string path;  ///< a serial port or a USB one; empty: the network
  std::string host;  ///< a name or an address
  int port = 10940;
  int baud = 115200;       ///< tried first, and set where the sensor is at another; a USB port ignores it
  double reply_s = 0.5;    ///< for an answer
  double connect_s = 3.0;  ///< for a connection
  RecoveryOptions recovery;

  std::string name() const { return path.empty() ? host + ":" + std::to_string(port) : path; }
  void validate() const;  ///< @throws InputError naming the first field out of range
};

/// Talks SCIP 2.0 to a sensor that may be in the middle of a stream, in SCIP 1.1, or setting its clock.
///
/// @par Source  Hokuyo, "Communication Protocol Specification for SCIP2.0 Standard", C-42-03320B. Checked
///              against captures of URG-04LX, UTM-30LX and UXM-30LX-E; no sensor was at hand.
class ScipClient {
 public:
  ScipClient(ByteLink& link, double reply_s, const StopSignal& stop);

  /// Stops whatever the sensor does and gets it to listen: out of a stream, SCIP 1.1 or the clock's mode.
  /// @returns false where nothing answers.
  bool synchronise();

  /// The same at another baud of the link.
  bool synchronise_at(int baud);

  /// Takes a sensor that listens at `baud`, and the link, to another one; the sensor keeps that until it is
  /// switched off. Where it refuses, or is not to be heard there, all stays as it was.
  /// @throws SensorFault kTimeout where it is to be heard at neither.
  void change_baud(int baud, int wanted_baud);

  /// Sends a command and gives its reply, echo first. Messages of others that come before it are dropped.
  /// @throws SensorFault kTimeout.
  std::vector<std::string> ask(const std::string& command);

  /// The next message; false where `timeout_s` passes first.
  bool next_message(std::vector<std::string>& lines, double timeout_s);

  /// When the sensor began to send the message that came last (steady_now_s): its time on the wire lies
  /// between, at most all of the time since the message before it.
  double sent_s() const { return sent_s_; }

  void send(const std::string& command);

  /// Of the last answer to QT that had one; empty before.
  const std::string& last_status() const { return last_status_; }

 private:
  bool quieten();

  ByteLink& link_;
  double reply_s_;
  const StopSignal& stop_;
  ScipReader reader_;
  std::string last_status_;
  double read_s_ = 0.0;  // when the last message was whole
  double sent_s_ = 0.0;
};

/// Two characters of a reply's status line: "00" is fine; "" where the line's sum is wrong.
std::string scip_status(std::span<const std::string> lines);

/// Makes scans of the messages of an MD stream.
class ScipScans {
 public:
  explicit ScipScans(const ScipParameters& parameters);

  /// The command that begins the stream.
  std::string command() const;

  enum class Outcome { kScan, kOther, kDamaged, kFault };

  /// @param sent_s  when the sensor began to send the message, at the end of the sweep at the earliest. The
  ///                stamp in it is of step 0, the scan's time that of its first beam.
  /// @returns kScan where `scan` is a new one; kDamaged where echo, sums or counts are wrong; kFault where
  /// the sensor
  ///          reports that it stopped.
  Outcome take(const std::vector<std::string>& message, double sent_s, LaserScan& scan);

 private:
  bool read_ranges(const std::string& data, LaserScan& scan) const;

  ScipParameters parameters_;
  ScanGeometry geometry_;
  DeviceClock clock_{24, 0.001};
};

/// A Hokuyo sensor.
/// @throws InputError where the options do not validate.
std::unique_ptr<RangeSensor> open_scip(const ScipOptions& options);

}  // namespace scanbed::hw
