// SPDX-License-Identifier: MIT
#include "hw/serial/serial_port.hpp"

// <termios.h> has neither termios2 nor BOTHER, and cannot be included beside this.
#include <asm/ioctls.h>
#include <asm/termbits.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "core/errors/sensor_fault.hpp"
#include "hw/serial/steady_clock.hpp"

namespace scanbed::hw {
namespace {

constexpr int kFastestUnpacedBaud = 115200;
constexpr double kByteGap_s = 60e-6;

std::string advice(int error, const std::string& path) {
  switch (error) {
    case ENOENT:
    case ENXIO:
    case ENODEV:
      return "no such port; is it plugged in? `scanbed devices` lists the ports";
    case EACCES:
    case EPERM:
      return "no permission; join the group that owns it: `sudo usermod -aG dialout $USER`, then log in "
             "again";
    case EBUSY:
    case EWOULDBLOCK:
      return "in use by another program; `fuser -v " + path + "` tells which";
    case ENOTTY:
      return "not a serial port; `scanbed devices` lists the ports";
    default:
      return std::strerror(error);
  }
}

FileDescriptor open_terminal(const std::string& path) {
  FileDescriptor fd(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!fd.is_open()) throw link_fault(path + ": " + advice(errno, path));
  termios2 settings{};
  if (::ioctl(fd.get(), TCGETS2, &settings) != 0) throw link_fault(path + ": " + advice(errno, path));
  return fd;
}

bool is_pseudo_terminal(int fd) {
  constexpr unsigned kFirstMajor = 136;  // of UNIX98 slaves, by Linux' list of devices
  constexpr unsigned kLastMajor = 143;
  struct stat status {};
  if (::fstat(fd, &status) != 0) return false;
  return major(status.st_rdev) >= kFirstMajor && major(status.st_rdev) <= kLastMajor;
}

FileDescriptor open_port(const std::string& path) {
  FileDescriptor fd = open_terminal(path);
  // TIOCEXCL keeps other users out, the lock also a second scanbed of the superuser. On a pseudo-terminal the
  // mark would outlive who is killed, as its other end stays open.
  if (::flock(fd.get(), LOCK_EX | LOCK_NB) != 0) throw link_fault(path + ": " + advice(errno, path));
  if (!is_pseudo_terminal(fd.get())) ::ioctl(fd.get(), TIOCEXCL);
  return fd;
}

/// Code of a baud in the standard table, so that programs that know no other codes can tell what is set; of
/// any other baud BOTHER.
tcflag_t baud_code(int baud) {
  switch (baud) {
    case 9600:
      return B9600;
    case 19200:
      return B19200;
    case 38400:
      return B38400;
    case 57600:
      return B57600;
    case 115200:
      return B115200;
    case 230400:
      return B230400;
    case 460800:
      return B460800;
    case 500000:
      return B500000;
    default:
      return BOTHER;
  }
}

/// Without sleep: on a busy machine that may take milliseconds, and a sensor gives up a request whose bytes
/// lie 6 ms apart.
void wait_for_gap() {
  const double end_s = steady_now_s() + kByteGap_s;
  while (steady_now_s() < end_s) continue;
}

void make_raw(termios2& settings, int baud) {
  const tcflag_t code = baud_code(baud);
  settings.c_iflag = 0;
  settings.c_oflag = 0;
  settings.c_lflag = 0;
  settings.c_cflag = CS8 | CREAD | CLOCAL | code | (code << IBSHIFT);
  settings.c_ispeed = static_cast<speed_t>(baud);
  settings.c_ospeed = static_cast<speed_t>(baud);
  settings.c_cc[VMIN] = 0;
  settings.c_cc[VTIME] = 0;
}

/// Whether the kernel's driver for devices that speak USB themselves has the port, unlike an adapter.
bool is_usb_device(const std::string& path) {
  std::error_code ignored;
  const std::filesystem::path real = std::filesystem::canonical(path, ignored);
  return real.filename().string().starts_with("ttyACM");
}

}  // namespace

SerialPort::SerialPort(const std::string& path)
    : path_(path), fd_(open_port(path)), is_usb_device_(is_usb_device(path)) {
  set_baud(9600);
}

SerialPort::~SerialPort() {
  // Where somebody else holds the port open, the mark would outlive this and keep the next user out.
  if (fd_.is_open()) ::ioctl(fd_.get(), TIOCNXCL);
}

void SerialPort::lose(const char* what) const {
  throw link_fault(path_ + ": port lost (" + what + "); was it unplugged?");
}

void SerialPort::set_baud(int baud) {
  termios2 settings{};
  if (::ioctl(fd_.get(), TCGETS2, &settings) != 0) lose(std::strerror(errno));
  make_raw(settings, baud);
  // Waits for what is still being sent, and drops what came in at the old baud.
  if (::ioctl(fd_.get(), TCSETSF2, &settings) != 0) lose(std::strerror(errno));
  termios2 now{};
  const bool has_taken_it =
      ::ioctl(fd_.get(), TCGETS2, &now) == 0 && std::abs(static_cast<int>(now.c_ospeed) - baud) * 50 <= baud;
  if (!has_taken_it) {
    throw UnsupportedBaud(path_ + ": the port cannot do " + std::to_string(baud) +
                          " baud; choose another with ?baud=");
  }
  baud_ = baud;
}

void SerialPort::flush_input() {
  ::ioctl(fd_.get(), TCFLSH, TCIFLUSH);
}

std::size_t SerialPort::read(std::span<std::uint8_t> buffer, double timeout_s, const StopSignal& stop) {
  if (!wait_for(fd_.get(), POLLIN, timeout_s, stop)) return 0;
  const ssize_t count = ::read(fd_.get(), buffer.data(), buffer.size());
  if (count > 0) return static_cast<std::size_t>(count);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return 0;
  // A port that can be read but gives nothing has hung up.
  lose(count == 0 ? "hung up" : std::strerror(errno));
}

void SerialPort::write_some(ByteView& bytes, const StopSignal& stop) {
  const bool is_paced = baud_ > kFastestUnpacedBaud;
  const ssize_t count = ::write(fd_.get(), bytes.data(), is_paced ? 1 : bytes.size());
  if (count > 0) {
    bytes = bytes.subspan(static_cast<std::size_t>(count));
    if (is_paced) wait_for_gap();
    return;
  }
  if (count < 0 && errno != EAGAIN && errno != EINTR) lose(std::strerror(errno));
  wait_for(fd_.get(), POLLOUT, 0.05, stop);
}

void SerialPort::write(ByteView bytes, const StopSignal& stop) {
  const double wire_s = static_cast<double>(bytes.size()) * 10.0 / baud_;
  const double deadline_s = steady_now_s() + wire_s + kWritePatience_s;
  while (!bytes.empty()) {
    write_some(bytes, stop);
    if (!bytes.empty() && steady_now_s() > deadline_s) {
      throw SensorFault(SensorFault::Kind::kTimeout, path_ + ": the port takes no bytes");
    }
  }
}

void check_port(const std::string& path) {
  open_terminal(path);
}

int terminal_baud(int fd) {
  termios2 settings{};
  return ::ioctl(fd, TCGETS2, &settings) == 0 ? static_cast<int>(settings.c_ospeed) : 0;
}

}  // namespace scanbed::hw
