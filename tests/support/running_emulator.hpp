// SPDX-License-Identifier: MIT
#pragma once

#include <thread>

#include "hw/sick/emulator_server.hpp"
#include "hw/sick/sick_options.hpp"
#include "tests/support/numbered_sensor.hpp"

namespace scanbed::tests {

/// An emulated LMS that a thread serves until this goes.
class RunningEmulator {
 public:
  explicit RunningEmulator(const hw::EmulatorOptions& options, hw::ScanSource source = numbered_source(),
                           hw::ScanFeed::Observer observer = {}, const std::filesystem::path& link = {})
      : server_(options, std::move(source), std::move(observer), link),
        thread_([this] { server_.run(stop_); }) {}

  ~RunningEmulator() {
    stop_.give();
    thread_.join();
  }

  std::string port() const { return server_.port(); }

  /// To be looked at once the thread has ended.
  const hw::EmulatedLms& end() {
    stop_.give();
    thread_.join();
    thread_ = std::thread([] {});
    return server_.lms();
  }

 private:
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

/// A driver that does not wait long for such a sensor, and drops nothing.
inline hw::SickOptions quick_driver(const std::string& port) {
  hw::SickOptions options;
  options.path = port;
  options.baud = 500000;
  options.is_lossless = true;
  options.patience = {
      .ack_s = 0.1, .reply_s = 0.3, .write_s = 1.0, .settle_s = 0.02, .silence_s = 0.15, .pause_s = 0.02};
  return options;
}

}  // namespace scanbed::tests
