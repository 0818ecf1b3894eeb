// SPDX-License-Identifier: MIT
#include "hw/serial/device_server.hpp"

#include <poll.h>

#include <algorithm>
#include <array>

#include "core/errors/sensor_fault.hpp"
#include "hw/serial/steady_clock.hpp"

namespace scanbed::hw {
namespace {

constexpr double kLongestSleep_s = 0.1;

double time_left_s(const ByteDevice& device) {
  return std::clamp(device.next_event_s() - steady_now_s(), 0.0, kLongestSleep_s);
}

void serve_host(ByteDevice& device, TcpLink& host, const StopSignal& stop) {
  std::array<std::uint8_t, 4096> buffer{};
  Bytes out;
  while (true) {
    const std::size_t count = host.read(buffer, time_left_s(device), stop);
    device.receive(ByteView(buffer).first(count), steady_now_s());
    out.clear();
    device.run(steady_now_s(), out);
    host.write(out, stop);
  }
}

void serve_next_host(ByteDevice& device, TcpListener& listener, const StopSignal& stop) {
  if (!wait_for(listener.fd(), POLLIN, kLongestSleep_s, stop)) return;
  FileDescriptor fd = listener.accept();
  if (!fd.is_open()) return;
  TcpLink host(std::move(fd));
  try {
    serve_host(device, host, stop);
  } catch (const SensorFault&) {
    device.hang_up();  // the host is gone; the next one may come
  }
}

}  // namespace

void serve(ByteDevice& device, TcpListener& listener, const StopSignal& stop) {
  try {
    while (true) serve_next_host(device, listener, stop);
  } catch (const Stopped&) {
    return;
  }
}

void serve(ByteDevice& device, PseudoTerminal& terminal, const StopSignal& stop) {
  Bytes in;
  Bytes out;
  try {
    while (true) {
      wait_for(terminal.fd(), POLLIN, time_left_s(device), stop);
      in.clear();
      out.clear();
      terminal.read(in);
      device.receive(in, steady_now_s());
      device.run(steady_now_s(), out);
      terminal.write(out);  // what the host does not take is lost, as on a wire
    }
  } catch (const Stopped&) {
    return;
  }
}

}  // namespace scanbed::hw
