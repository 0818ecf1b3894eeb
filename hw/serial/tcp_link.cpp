// SPDX-License-Identifier: MIT
#include "hw/serial/tcp_link.hpp"

#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <future>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

#include "core/errors/sensor_fault.hpp"
#include "hw/serial/steady_clock.hpp"

namespace scanbed::hw {
namespace {

struct FreeAddresses {
  void operator()(addrinfo* list) const { ::freeaddrinfo(list); }
};
using Addresses = std::unique_ptr<addrinfo, FreeAddresses>;

Addresses look_up(const std::string& host, int port) {
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int error = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
  if (error != 0) throw link_fault(host + ": no such host (" + ::gai_strerror(error) + ")");
  return Addresses(found);
}

// Where no name server answers, as often in a sensor's own network, a look-up takes many seconds and cannot
// be interrupted: it is left to itself then.
Addresses resolve(const std::string& host, int port, const StopSignal& stop) {
  std::packaged_task<Addresses()> task([host, port] { return look_up(host, port); });
  std::future<Addresses> addresses = task.get_future();
  try {
    std::thread(std::move(task)).detach();
  } catch (const std::system_error&) {
    return look_up(host, port);  // no thread is to be had
  }
  while (addresses.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) stop.sleep(0.01);
  return addresses.get();
}

// What the socket says once it can be written: 0 where it is connected.
int pending_error(int fd) {
  int error = 0;
  socklen_t size = sizeof error;
  if (::getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &size) != 0) return errno;
  return error;
}

FileDescriptor connect_to(const addrinfo& address, double timeout_s, const StopSignal& stop, int& error) {
  FileDescriptor fd(
      ::socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, address.ai_protocol));
  error = errno;
  if (!fd.is_open()) return fd;
  error = ::connect(fd.get(), address.ai_addr, address.ai_addrlen) == 0 ? 0 : errno;
  if (error == EINPROGRESS) {
    error = wait_for(fd.get(), POLLOUT, timeout_s, stop) ? pending_error(fd.get()) : ETIMEDOUT;
  }
  if (error != 0) fd.reset();
  return fd;
}

void send_at_once(int fd) {
  const int on = 1;
  ::setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

FileDescriptor open_connection(const std::string& host, int port, double timeout_s, const StopSignal& stop) {
  const Addresses addresses = resolve(host, port, stop);
  int error = 0;
  for (const addrinfo* address = addresses.get(); address != nullptr; address = address->ai_next) {
    FileDescriptor fd = connect_to(*address, timeout_s, stop, error);
    if (fd.is_open()) return fd;
  }
  throw link_fault(host + ":" + std::to_string(port) + ": cannot connect (" + std::strerror(error) +
                   "); is the sensor on, in this network, and has it no other client?");
}

}  // namespace

TcpLink::TcpLink(const std::string& host, int port, double timeout_s, const StopSignal& stop)
    : name_(host + ":" + std::to_string(port)), fd_(open_connection(host, port, timeout_s, stop)) {
  send_at_once(fd_.get());
}

TcpLink::TcpLink(FileDescriptor fd) : name_("client"), fd_(std::move(fd)) {
  send_at_once(fd_.get());
}

std::size_t TcpLink::read(std::span<std::uint8_t> buffer, double timeout_s, const StopSignal& stop) {
  if (!wait_for(fd_.get(), POLLIN, timeout_s, stop)) return 0;
  const ssize_t count = ::recv(fd_.get(), buffer.data(), buffer.size(), 0);
  if (count > 0) return static_cast<std::size_t>(count);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return 0;
  throw link_fault(name_ + ": the other end closed the connection");
}

void TcpLink::write(ByteView bytes, const StopSignal& stop) {
  const double deadline_s = steady_now_s() + kWritePatience_s;
  while (!bytes.empty()) {
    const ssize_t count = ::send(fd_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(count));
      continue;
    }
    if (count < 0 && errno != EAGAIN && errno != EINTR) throw link_fault(name_ + ": " + std::strerror(errno));
    wait_for(fd_.get(), POLLOUT, 0.05, stop);
    if (steady_now_s() > deadline_s) {
      throw SensorFault(SensorFault::Kind::kTimeout, name_ + ": the other end takes no bytes");
    }
  }
}

void TcpLink::flush_input() {
  std::array<std::uint8_t, 4096> buffer{};
  while (::recv(fd_.get(), buffer.data(), buffer.size(), MSG_DONTWAIT) > 0) continue;
}

TcpListener::TcpListener(int port) : fd_(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
  const int on = 1;
  ::setsockopt(fd_.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const generic = reinterpret_cast<sockaddr*>(&address);
  if (::bind(fd_.get(), generic, size) != 0 || ::listen(fd_.get(), 4) != 0 ||
      ::getsockname(fd_.get(), generic, &size) != 0) {
    throw link_fault("port " + std::to_string(port) + ": " + std::strerror(errno));
  }
  port_ = ntohs(address.sin_port);
}

FileDescriptor TcpListener::accept() {
  return FileDescriptor(::accept4(fd_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
}

}  // namespace scanbed::hw
