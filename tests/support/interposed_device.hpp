// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hw/serial/device_server.hpp"

namespace scanbed::tests {

/// Stands before an emulated device: what it does not answer itself, it hands on.
class InterposedDevice : public hw::ByteDevice {
 public:
  /// @param device  must outlive this.
  explicit InterposedDevice(hw::ByteDevice& device) : device_(device) {}

  void run(double now_s, hw::Bytes& out) final {
    out.insert(out.end(), answer_.begin(), answer_.end());
    answer_.clear();
    device_.run(now_s, out);
  }
  double next_event_s() const final { return device_.next_event_s(); }
  void hang_up() final { device_.hang_up(); }

 protected:
  void answer(std::string_view text) { answer_.assign(text.begin(), text.end()); }
  void hand_on(hw::ByteView bytes, double now_s) { device_.receive(bytes, now_s); }

 private:
  hw::ByteDevice& device_;
  hw::Bytes answer_;
};

}  // namespace scanbed::tests
