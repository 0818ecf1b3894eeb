// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "core/scan/range_sensor.hpp"
#include "hw/cola/cola_frame.hpp"
#include "hw/serial/byte_link.hpp"
#include "hw/serial/recovering_laser.hpp"

namespace scanbed::hw {

/// What `cola:HOST[:PORT]` says.
struct ColaOptions {
  std::string host;
  int port = 2111;  ///< 2111 or 2112; both speak the same unless one is set to binary
  double connect_s = 5.0;
  double reply_s = 5.0;     ///< for an answer; a sensor that lost its client may take long
  double spin_up_s = 60.0;  ///< for the motor, after power-on
  double poll_s = 0.5;      ///< between two questions whether the motor is up
  RecoveryOptions recovery;

  void validate() const;  ///< @throws InputError naming the first field out of range
};

/// Requests to a sensor, one at a time; scans may come between a request and its answer.
class ColaClient {
 public:
  ColaClient(ByteLink& link, double reply_s, const StopSignal& stop);

  /// @returns the answer's body: "sAN Run 1", or "sFA 3".
  /// @throws SensorFault kTimeout where none comes; kProtocol where the sensor speaks CoLa B.
  std::string ask(const std::string& request);

  /// The next body that is a scan; false where `timeout_s` passes first.
  bool next_scan(std::string& body, double timeout_s);

  void send(const std::string& request);

 private:
  bool next_body(std::string& body, double deadline_s);

  ByteLink& link_;
  double reply_s_;
  const StopSignal& stop_;
  ColaReader reader_;
  bool has_heard_ = false;  // anything from the other end
};

/// A SICK LMS1xx or TiM in the network.
/// @throws InputError where the options do not validate.
std::unique_ptr<RangeSensor> open_cola(const ColaOptions& options);

}  // namespace scanbed::hw
