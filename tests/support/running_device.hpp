// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <thread>

#include "hw/serial/device_server.hpp"

namespace scanbed::tests {

/// An emulated device that a thread serves in the network until this goes.
class RunningDevice {
 public:
  explicit RunningDevice(hw::ByteDevice& device, int port = 0)
      : listener_(port), thread_([this, &device] { hw::serve(device, listener_, stop_); }) {}
  ~RunningDevice() {
    stop_.give();
    thread_.join();
  }
  int port() const { return listener_.port(); }

 private:
  hw::StopSignal stop_;
  hw::TcpListener listener_;
  std::thread thread_;
};

}  // namespace scanbed::tests
