// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/scan/range_sensor.hpp"
#include "hw/sick/sick_options.hpp"

namespace scanbed::hw {

/// What a driver has seen so far.
struct SickReport {
  std::string state;       ///< "opening", "looking for the sensor", "configuring", "streaming", "recovering"
  std::string last_fault;  ///< empty where there was none
  std::string type;        ///< of the sensor: "LMS200;301063;V02.10 "; empty before it answered
  SensorHealth health;     ///< of the last scan
  std::int64_t num_scans = 0;
  std::int64_t num_refused_telegrams = 0;  ///< with a good check word, but not what was configured
  std::int64_t num_crc_errors = 0;
  std::int64_t num_garbage_bytes = 0;
  std::int64_t num_restarts = 0;  ///< times that the sensor had to be looked for again
  std::int64_t num_dropped = 0;   ///< scans dropped since nobody took them
};

/// A SICK LMS 2xx at a serial port.
///
/// A thread of its own reads the port, so that scans get the time at which they arrived however busy the
/// reader is. It finds the sensor at whatever baud, sets it up and streams; when the stream fails (damage,
/// silence, a reboot, a cable pulled out) it starts over, without end, and next() meanwhile times out.
///
/// Two flipped bits that the check word misses (crc.hpp) are noticed in a telegram's head, not in its ranges:
/// nothing in the protocol tells those from measured ones.
/// @par Cost  0.75 to 0.84 us of CPU from the 732 bytes of a telegram to a scan, check word included
///            (bench/hw/sick, release, a shared virtual x86 machine of 2.6 GHz): some 2200 cycles, at 37.5 Hz
///            0.01 % of a core of 1 GHz. Reading the port costs more: the thread as a whole, system calls
///            included, took 5.0 ms/s at 37.5 Hz through a pseudo-terminal at 500000 baud (130 us and 3.3
///            wake-ups a scan; 350 000 cycles) and 2.1 ms/s at 38400. Budget for a core of 1.5 GHz that needs
///            twice the cycles, as a Raspberry's may: 1.8 % at 37.5 Hz. Not measured on one.
class SickLms final : public RangeSensor {
 public:
  /// Starts to look for the sensor and returns at once.
  /// @throws InputError where the options do not validate.
  explicit SickLms(const SickOptions& options);

  /// Stops the stream, gives the sensor back the baud that it was found at, and returns within 0.2 s.
  ~SickLms() override;

  /// From the options; the sensor's measuring mode may yet extend the greatest range.
  const ScanGeometry& geometry() const override;

  /// Times are seconds since a scan and its telegram before construction, and never negative. False once
  /// stop() was called.
  /// @throws SensorFault kTimeout where no scan comes in time, saying what the driver is at.
  /// @throws SensorFault of another kind where it gave up: port or sensor not found at the start, or a
  ///         setting that the sensor refuses.
  bool next(LaserScan& scan, Seconds timeout) override;

  /// Ends the stream for good, from any thread: next() returns false.
  void stop();

  SickReport report() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scanbed::hw
