// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <thread>

#include "hw/sick/emulator_server.hpp"
#include "hw/sick/sick_options.hpp"
#include "tests/support/numbered_sensor.hpp"

namespace scanbed::tests {

/// An emulated LMS that a thread serves until this goes.
class RunningEmulator {
 public:
  explicit RunningEmulator(const hw::EmulatorOptions& options, hw::ScanSupply source = numbered_source(),
                           hw::ScanFeed::Observer observer = {}, const std::filesystem::path& link = {})
      : server_(options, std::move(source), watched(std::move(observer)), link),
        thread_([this] { server_.run(stop_); }) {}

  ~RunningEmulator() {
    stop_.give();
    thread_.join();
  }

  std::string port() const { return server_.port(); }

  /// To be touched by the observer alone, which is called in the emulator's thread.
  hw::EmulatedLms& lms() { return server_.lms(); }

  /// Faults that had come into effect when the last scan was sent; may be asked for while it runs.
  std::int64_t num_faults() const { return num_faults_.load(); }

  /// To be looked at once the thread has ended.
  const hw::EmulatedLms& end() {
    stop_.give();
    thread_.join();
    thread_ = std::thread([] {});
    return server_.lms();
  }

 private:
  hw::ScanFeed::Observer watched(hw::ScanFeed::Observer observer) {
    return [this, observer = std::move(observer)](const hw::SentScan& sent) {
      num_faults_.store(server_.lms().counts().num_faults);
      if (observer) observer(sent);
    };
  }

  std::atomic<std::int64_t> num_faults_{0};
  hw::EmulatorServer server_;
  hw::StopSignal stop_;
  std::thread thread_;
};

/// A sensor that answers at once and streams as fast as it is read.
inline hw::EmulatorOptions quick_sensor() {
  hw::EmulatorOptions options;
  options.is_paced = false;
  options.silence_s = 0.4;
  options.unplug_s = 0.2;
  return options;
}

/// The same, found where a driver looks first.
inline hw::EmulatorOptions quick_sensor_at(int baud) {
  hw::EmulatorOptions options = quick_sensor();
  options.power_on_baud = baud;
  return options;
}

/// A driver that does not wait long for such a sensor, and drops nothing. On a busy machine it may give up
/// what is only late, and starts over: only true scans come, but some may be left out.
inline hw::SickOptions quick_driver(const std::string& port) {
  hw::SickOptions options;
  options.path = port;
  options.baud = 500000;
  options.is_lossless = true;
  options.patience = {
      .ack_s = 0.1, .reply_s = 0.3, .write_s = 1.0, .settle_s = 0.02, .silence_s = 0.15, .pause_s = 0.02};
  options.patience.num_first_attempts = 1000;
  return options;
}

/// A driver for a sensor without faults whose baud it knows: it waits longer than any machine is busy, and
/// starts over for nothing. A request or answer that a busy machine tears apart is asked for again.
inline hw::SickOptions patient_driver(const std::string& port) {
  hw::SickOptions options = quick_driver(port);
  options.patience = {
      .ack_s = 5.0, .reply_s = 5.0, .write_s = 20.0, .settle_s = 0.02, .silence_s = 20.0, .close_s = 20.0};
  return options;
}

}  // namespace scanbed::tests
