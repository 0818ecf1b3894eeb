// SPDX-License-Identifier: MIT
#include "tests/support/foreign_lms.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "tests/support/numbered_steps.hpp"

namespace scanbed::tests {
namespace {

constexpr std::array<std::uint8_t, 4> kTurnOrder = {0, 2, 1, 3};
constexpr std::string_view kType = "LMS200;301063;V02.10 ";

unsigned check_word(const std::vector<std::uint8_t>& bytes) {
  unsigned crc = 0;
  unsigned last = 0;
  for (const unsigned byte : bytes) {
    const bool carry = crc >= 0x8000;
    crc = (2 * crc) % 0x10000;
    if (carry) crc ^= 0x8005;
    crc ^= byte + 256 * last;
    last = byte;
  }
  return crc;
}

void put_u16(std::vector<std::uint8_t>& bytes, std::size_t at, unsigned value) {
  bytes.at(at) = static_cast<std::uint8_t>(value % 256);
  bytes.at(at + 1) = static_cast<std::uint8_t>(value / 256);
}

void push_u16(std::vector<std::uint8_t>& bytes, unsigned value) {
  bytes.resize(bytes.size() + 2);
  put_u16(bytes, bytes.size() - 2, value);
}

int baud_of(speed_t speed) {
  switch (speed) {
    case B9600:
      return 9600;
    case B19200:
      return 19200;
    case B38400:
      return 38400;
    case B500000:
      return 500000;
    default:
      return 0;
  }
}

}  // namespace

ForeignLms::ForeignLms(const ForeignHabits& habits)
    : habits_(habits),
      configuration_(habits.configuration_bytes, 0),
      baud_(habits.power_on_baud),
      mode_(habits.streams_at_power_on ? 0x24 : 0x25) {
  configuration_.at(2) = 0x46;
  configuration_.at(4) = habits.sends_indices ? 0x02 : 0x00;
  configuration_.at(5) = habits.measuring_mode;
  configuration_.at(6) = habits.is_in_millimetres ? 1 : 0;
  configuration_.at(9) = configuration_.at(10) = 2;
  static std::atomic<int> count{0};
  link_ = (std::filesystem::temp_directory_path() /
           ("foreign_" + std::to_string(::getpid()) + "_" + std::to_string(count++)))
              .string();
  plug();
  thread_ = std::thread([this] { serve(); });
}

ForeignLms::~ForeignLms() {
  is_over_ = true;
  thread_.join();
  unplug();
}

void ForeignLms::plug() {
  termios raw{};
  cfmakeraw(&raw);
  cfsetspeed(&raw, B9600);
  std::array<char, 128> name{};
  if (openpty(&master_, &slave_, name.data(), &raw, nullptr) != 0) throw std::runtime_error("openpty");
  ::fcntl(master_, F_SETFL, O_NONBLOCK);
  std::filesystem::remove(link_);  // a run that was killed may have had this process's number
  std::filesystem::create_symlink(name.data(), link_);
}

void ForeignLms::unplug() {
  std::filesystem::remove(link_);
  ::close(master_);
  ::close(slave_);
}

int ForeignLms::host_baud() const {
  termios settings{};
  return tcgetattr(master_, &settings) == 0 ? baud_of(cfgetospeed(&settings)) : 0;
}

void ForeignLms::pause(double duration_s) const {
  if (duration_s > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(duration_s));
}

bool ForeignLms::has_failed() const {
  for (int i = 0; i < 2000 && fault_ != ForeignFault::kNone; ++i) pause(0.01);
  return fault_ == ForeignFault::kNone;
}

bool ForeignLms::take(ForeignFault fault) {
  ForeignFault expected = fault;
  return fault_.compare_exchange_strong(expected, ForeignFault::kNone);
}

void ForeignLms::serve() {
  while (!is_over_) {
    pollfd waiting{master_, POLLIN, 0};
    const bool is_talking = is_streaming() && host_baud() == baud_;
    ::poll(&waiting, 1, is_talking ? 0 : 2);
    hear();
    while (take_request()) continue;
    if (is_streaming()) stream();
  }
}

void ForeignLms::hear() {
  std::array<std::uint8_t, 512> chunk{};
  const ssize_t count = ::read(master_, chunk.data(), chunk.size());
  // At another baud there is nothing to understand.
  if (count <= 0 || host_baud() != baud_) return;
  heard_.insert(heard_.end(), chunk.begin(), chunk.begin() + count);
}

/// Whether something was taken off the front of what was heard.
bool ForeignLms::take_request() {
  if (heard_.empty()) return false;
  if (heard_[0] != 0x02) {
    heard_.erase(heard_.begin());
    return true;
  }
  if (heard_.size() < 4) return false;
  const std::size_t length = heard_[2] + 256U * heard_[3];
  if (heard_.size() < length + 6) return false;
  const Bytes head(heard_.begin(), heard_.begin() + static_cast<std::ptrdiff_t>(length + 4));
  const unsigned stated = heard_[length + 4] + 256U * heard_[length + 5];
  heard_.erase(heard_.begin(), heard_.begin() + static_cast<std::ptrdiff_t>(length + 6));
  if (head[1] != 0 || take(ForeignFault::kDeaf)) return true;
  if (stated != check_word(head) || take(ForeignFault::kNak)) {
    put({0x15}, false);
    return true;
  }
  answer({head.begin() + 4, head.end()});
  return true;
}

void ForeignLms::put(const Bytes& bytes, bool can_be_broken_off) {
  for (std::size_t sent = 0; sent < bytes.size() && !is_over_;) {
    const std::size_t left = bytes.size() - sent;
    const std::size_t most = habits_.piece_bytes > 0 ? std::min(habits_.piece_bytes, left) : left;
    const ssize_t count = ::write(master_, bytes.data() + sent, most);
    if (count > 0) sent += static_cast<std::size_t>(count);
    if (sent < bytes.size()) pause(habits_.piece_s);
    pollfd waiting{master_, static_cast<short>(count > 0 ? POLLIN : POLLIN | POLLOUT), 0};
    const bool is_spoken_to = ::poll(&waiting, 1, count > 0 ? 0 : 5) > 0 && (waiting.revents & POLLIN) != 0;
    if (can_be_broken_off && is_spoken_to && habits_.breaks_off && sent > bytes.size() / 3) return;
    if (can_be_broken_off && is_spoken_to && count <= 0) return;
  }
}

ForeignLms::Bytes ForeignLms::framed(const Bytes& body, bool with_status) const {
  Bytes bytes{0x02, habits_.reply_address, 0, 0};
  bytes.insert(bytes.end(), body.begin(), body.end());
  if (with_status) bytes.push_back(habits_.status);
  put_u16(bytes, 2, static_cast<unsigned>(bytes.size() - 4));
  push_u16(bytes, check_word(bytes));
  return bytes;
}

void ForeignLms::acknowledge() {
  pause(habits_.ack_s);
  if (habits_.acknowledges && !habits_.acknowledges_late && !take(ForeignFault::kLostAck)) put({0x06}, false);
}

void ForeignLms::reply(const Bytes& body, double after_s) {
  pause(after_s);
  put(framed(body, true), false);
  if (habits_.acknowledges && habits_.acknowledges_late) put({0x06}, false);
}

void ForeignLms::answer(const Bytes& body) {
  if (is_fresh_ && habits_.says_power_on) {
    is_fresh_ = false;
    Bytes text{0x90};
    text.insert(text.end(), kType.begin(), kType.end());
    return reply(text, 0.0);
  }
  acknowledge();
  Bytes type{0xBA};
  type.insert(type.end(), kType.begin(), kType.end());
  Bytes configuration{0xF4};
  configuration.insert(configuration.end(), configuration_.begin(), configuration_.end());
  switch (body.at(0)) {
    case 0x20:
      return answer_mode(body);
    case 0x31:
      return reply(account(), habits_.reply_s);
    case 0x32:
      return habits_.knows_diagnostics ? reply({0xB2, 0x02, 0x11, 0x81, 0x05}, habits_.reply_s) : refuse();
    case 0x3A:
      return habits_.knows_diagnostics ? reply(type, habits_.reply_s) : refuse();
    case 0x3B:
      return answer_variant(body);
    case 0x74:
      return reply(configuration, habits_.reply_s);
    case 0x77:
      return answer_write(body);
    default:
      return refuse();
  }
}

void ForeignLms::answer_mode(const Bytes& body) {
  const int mode = body.at(1);
  switch (mode) {
    case 0x42:
      return answer_baud(9600);
    case 0x41:
      return answer_baud(19200);
    case 0x40:
      return answer_baud(38400);
    case 0x48:
      return answer_baud(500000);
    default:
      break;
  }
  const std::string& password = habits_.password;
  const bool is_known = mode == 0x24 || mode == 0x25 || mode == 0x2A;
  const bool is_allowed =
      mode == 0x00 && std::equal(body.begin() + 2, body.end(), password.begin(), password.end());
  if (!is_known && !is_allowed) return reply({0xA0, 0x01}, habits_.reply_s);
  turn_ = 0;
  if (habits_.streams_before_reply && mode == 0x24) put(next_scan(), false);
  reply({0xA0, 0x00}, habits_.mode_s);
  mode_ = mode;
}

void ForeignLms::answer_baud(int baud) {
  const bool is_known = std::find(habits_.bauds.begin(), habits_.bauds.end(), baud) != habits_.bauds.end();
  reply({0xA0, static_cast<std::uint8_t>(is_known ? 0 : 1)}, habits_.mode_s);
  if (!is_known) return;
  baud_ = baud;
  heard_.clear();
}

void ForeignLms::answer_variant(const Bytes& body) {
  const int fov_deg = body.at(1) + 256 * body.at(2);
  const int resolution_cdeg = body.at(3) + 256 * body.at(4);
  const bool is_offered =
      (fov_deg == 180 && (resolution_cdeg == 50 || resolution_cdeg == 100)) ||
      (fov_deg == 100 && (resolution_cdeg == 25 || resolution_cdeg == 50 || resolution_cdeg == 100));
  if (is_offered) {
    fov_deg_ = fov_deg;
    resolution_cdeg_ = resolution_cdeg;
  }
  Bytes answer{0xBB, static_cast<std::uint8_t>(is_offered ? 1 : 0)};
  push_u16(answer, static_cast<unsigned>(fov_deg_));
  push_u16(answer, static_cast<unsigned>(resolution_cdeg_));
  reply(answer, habits_.mode_s);
}

void ForeignLms::answer_write(const Bytes& body) {
  if (mode_ != 0x00) return refuse();
  const bool is_fine = body.size() == configuration_.size() + 1;
  if (is_fine) {
    configuration_.assign(body.begin() + 1, body.end());
    if (habits_.changes_other_bytes) configuration_.at(2) = 0x60;
    ++num_writes_;
  }
  Bytes answer{0xF7, static_cast<std::uint8_t>(is_fine ? 1 : 0)};
  answer.insert(answer.end(), configuration_.begin(), configuration_.end());
  reply(answer, habits_.write_s);
}

/// B1h: 152 bytes between command and status.
ForeignLms::Bytes ForeignLms::account() const {
  Bytes bytes(153, 0);
  bytes[0] = 0xB1;
  const std::string_view firmware = "V02.10 ";
  std::copy(firmware.begin(), firmware.end(), bytes.begin() + 1);
  bytes[8] = static_cast<std::uint8_t>(mode_);
  bytes[102] = configuration_[5];
  put_u16(bytes, 107, static_cast<unsigned>(fov_deg_));
  put_u16(bytes, 109, static_cast<unsigned>(resolution_cdeg_));
  const int baud = baud_;
  put_u16(bytes, 116, baud == 9600 ? 0x8067 : baud == 19200 ? 0x8033 : baud == 38400 ? 0x8019 : 0x8001);
  bytes[120] = habits_.reply_address % 0x80;
  bytes[122] = configuration_[6];
  return bytes;
}

/// The next telegram of the stream: a scan, or one turn of four.
ForeignLms::Bytes ForeignLms::next_scan() {
  const bool has_turns = mode_ == 0x2A;
  const int turn = habits_.sends_turns_out_of_order ? kTurnOrder.at(static_cast<std::size_t>(turn_)) : turn_;
  const int num_beams = has_turns ? (turn == 0 ? 181 : 180) : fov_deg_ * 100 / resolution_cdeg_ + 1;
  Bytes body{0xB0};
  push_u16(body, static_cast<unsigned>(num_beams) + (has_turns ? 0x2000U + 0x800U * turn : 0U) +
                     (configuration_[6] == 1 ? 0x4000U : 0U));
  for (int i = 0; i < num_beams; ++i) {
    push_u16(body, static_cast<unsigned>(numbered_steps(num_scans_, has_turns ? 4 * i + turn : i)));
  }
  if ((configuration_[4] & 0x02) != 0) {
    body.push_back(static_cast<std::uint8_t>(num_scans_ % 256));
    body.push_back(static_cast<std::uint8_t>((num_scans_ * 4 + turn_) % 256));
  }
  if (has_turns) turn_ = (turn_ + 1) % 4;
  if (turn_ == 0) ++num_scans_;
  return framed(body, true);
}

void ForeignLms::go_wrong_in_stream(Bytes& telegram) {
  if (take(ForeignFault::kFlip)) telegram.at(telegram.size() / 2) ^= 0x08;
  if (take(ForeignFault::kHalf)) telegram.resize(telegram.size() / 2);
  if (take(ForeignFault::kGarbage)) {
    const Bytes garbage = {0x06, 0x15, 0x02, 0x80, 0x28, 0x03, 0xB0, 0x02, 0x80, 0x02};
    telegram.insert(telegram.begin(), garbage.begin(), garbage.end());
  }
  if (take(ForeignFault::kBlindHeadPair)) {
    telegram.at(5) ^= 0x01;
    telegram.at(6) ^= 0x02;
  }
  const auto reframed = [&] { return framed({telegram.begin() + 4, telegram.end() - 3}, true); };
  if (take(ForeignFault::kOtherUnit)) {
    telegram.at(6) ^= 0x40;
    telegram = reframed();
  }
  if (take(ForeignFault::kShort)) {
    telegram.at(5) = static_cast<std::uint8_t>(telegram.at(5) - 1);
    telegram.erase(telegram.end() - 5, telegram.end() - 3);
    telegram = reframed();
  }
}

/// What arrives at another baud: never a telegram, but all that one is made of.
ForeignLms::Bytes ForeignLms::noise() {
  Bytes bytes(20);
  for (std::uint8_t& byte : bytes) {
    chance_ = chance_ * 1664525U + 1013904223U;
    byte = static_cast<std::uint8_t>(chance_ >> 24U);
  }
  bytes[5] = 0x06;
  bytes[9] = 0x15;
  bytes[11] = 0x02;
  bytes[12] = 0x80;
  return bytes;
}

void ForeignLms::reboot() {
  mode_ = 0x25;
  pause(0.2);
  baud_ = habits_.power_on_baud;
  heard_.clear();
  Bytes text{0x90};
  text.insert(text.end(), kType.begin(), kType.end());
  if (host_baud() == baud_) reply(text, 0.0);
}

void ForeignLms::stream() {
  if (host_baud() != baud_) {
    if (habits_.talks_at_other_bauds) put(noise(), true);
    return pause(0.001);
  }
  Bytes telegram = next_scan();
  go_wrong_in_stream(telegram);
  put(telegram, true);
  if (take(ForeignFault::kSilence)) pause(0.4);
  if (take(ForeignFault::kReboot)) reboot();
  if (take(ForeignFault::kUnplug)) {
    unplug();
    pause(0.2);
    plug();
  }
}

}  // namespace scanbed::tests
