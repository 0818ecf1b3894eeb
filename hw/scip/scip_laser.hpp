// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
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
  int baud = 115200;       ///< tried first; a USB port ignores it
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

  /// Sends a command and gives its reply, echo first. Messages of others that come before it are dropped.
  /// @throws SensorFault kTimeout.
  std::vector<std::string> ask(const std::string& command);

  /// The next message; false where `timeout_s` passes first.
  bool next_message(std::vector<std::string>& lines, double timeout_s);

  void send(const std::string& command);

 private:
  bool quieten();

  ByteLink& link_;
  double reply_s_;
  const StopSignal& stop_;
  ScipReader reader_;
};

/// Two characters of a reply's status line: "00" is fine; "" where the line's sum is wrong.
std::string scip_status(const std::vector<std::string>& lines);

/// Makes scans of the messages of an MD stream.
class ScipScans {
 public:
  explicit ScipScans(const ScipParameters& parameters);

  /// The command that begins the stream.
  std::string command() const;

  enum class Outcome { kScan, kOther, kDamaged, kFault };

  /// @returns kScan where `scan` is a new one; kDamaged where sums or counts are wrong; kFault where the
  /// sensor
  ///          reports that it stopped.
  Outcome take(const std::vector<std::string>& lines, double arrival_s, LaserScan& scan);

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
