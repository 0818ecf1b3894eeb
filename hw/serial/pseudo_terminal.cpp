// SPDX-License-Identifier: MIT
#include "hw/serial/pseudo_terminal.hpp"

#include <fcntl.h>
#include <termios.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/errors/input_error.hpp"
#include "core/errors/sensor_fault.hpp"
#include "hw/serial/serial_port.hpp"

namespace scanbed::hw {
namespace {

SensorFault terminal_fault(const char* what) {
  return {SensorFault::Kind::kDisconnected,
          std::string("pseudo-terminal: ") + what + ": " + std::strerror(errno)};
}

// Else the line discipline would echo the sensor's own bytes back to it.
void make_raw(int fd) {
  termios settings{};
  if (tcgetattr(fd, &settings) != 0) throw terminal_fault("tcgetattr");
  cfmakeraw(&settings);
  cfsetspeed(&settings, B9600);
  if (tcsetattr(fd, TCSANOW, &settings) != 0) throw terminal_fault("tcsetattr");
}

/// A lock on the whole of a port. Hosts lock it by flock(), which knows nothing of these; the system drops it
/// with the last descriptor, so that a program that was killed leaves none behind.
struct flock whole_file_lock() {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return lock;
}

/// Whether a pseudo-terminal of this kind is at the other end of a link's target. Its number alone tells
/// nothing: once it is free, the next terminal gets it.
bool is_served(const std::string& target) {
  if (!target.starts_with("/dev/pts/")) return false;
  const FileDescriptor fd(::open(target.c_str(), O_RDONLY | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  // In use by a host, which keeps all others out.
  if (!fd.is_open()) return errno == EBUSY;
  struct flock lock = whole_file_lock();
  return ::fcntl(fd.get(), F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

void put_link(const std::filesystem::path& link, const std::string& target) {
  std::error_code error;
  const auto status = std::filesystem::symlink_status(link, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_symlink(status)) {
    throw InputError(link.string() + ": exists and is no symbolic link; choose another name");
  }
  const std::string older = std::filesystem::read_symlink(link, error).string();
  if (older != target && is_served(older)) {
    throw SensorFault(SensorFault::Kind::kDisconnected,
                      link.string() + ": another emulator is at this name; end it, or choose another name");
  }
  std::filesystem::remove(link, error);
  std::filesystem::create_symlink(target, link, error);
  if (error) {
    throw SensorFault(SensorFault::Kind::kDisconnected,
                      link.string() + ": cannot make the link: " + error.message());
  }
}

}  // namespace

PseudoTerminal::PseudoTerminal(std::filesystem::path link) : link_(std::move(link)) {
  plug();
}

PseudoTerminal::~PseudoTerminal() {
  remove_link();
}

void PseudoTerminal::remove_link() {
  if (link_.empty()) return;
  std::error_code error;
  // Another emulator may have taken the name over while this one was unplugged.
  if (std::filesystem::read_symlink(link_, error) == path_) std::filesystem::remove(link_, error);
}

void PseudoTerminal::plug() {
  master_.reset(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!master_.is_open()) throw terminal_fault("posix_openpt");
  if (grantpt(master_.get()) != 0 || unlockpt(master_.get()) != 0) throw terminal_fault("unlockpt");
  std::array<char, 128> name{};
  if (ptsname_r(master_.get(), name.data(), name.size()) != 0) throw terminal_fault("ptsname");
  path_ = name.data();
  slave_.reset(::open(path_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  if (!slave_.is_open()) throw terminal_fault(name.data());
  make_raw(slave_.get());
  struct flock lock = whole_file_lock();
  if (::fcntl(slave_.get(), F_OFD_SETLK, &lock) != 0) throw terminal_fault("lock");
  if (!link_.empty()) put_link(link_, path_);
}

void PseudoTerminal::unplug() {
  remove_link();
  slave_.reset();
  master_.reset();
}

int PseudoTerminal::host_baud() const {
  return terminal_baud(master_.get());
}

void PseudoTerminal::read(Bytes& bytes) {
  std::array<std::uint8_t, 4096> chunk{};
  while (is_plugged()) {
    const ssize_t count = ::read(master_.get(), chunk.data(), chunk.size());
    if (count <= 0) return;
    bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + count);
  }
}

std::size_t PseudoTerminal::write(ByteView bytes) {
  if (!is_plugged() || bytes.empty()) return 0;
  const ssize_t count = ::write(master_.get(), bytes.data(), bytes.size());
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

}  // namespace scanbed::hw
