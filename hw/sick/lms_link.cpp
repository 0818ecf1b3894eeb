// SPDX-License-Identifier: MIT
#include "hw/sick/lms_link.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "hw/serial/steady_clock.hpp"

namespace scanbed::hw {
namespace {

// The shortest pause that a sensor wants after it said NAK.
constexpr double kPauseAfterNak_s = 0.03;
// A sensor that acknowledged is quiet until it answers. More garbage than this behind an acknowledgement, and
// it was garbage itself: a stream at another baud is full of them.
constexpr std::int64_t kMostGarbageAfterAck = 32;
// Nothing is read for longer in one go, so that half a telegram expires in time.
constexpr double kLongestRead_s = 0.5 * TelegramDecoder::kExpiry_s;
constexpr std::size_t kReadBytes = 4096;
constexpr std::size_t kLargePieceBytes = kReadBytes / 4;
constexpr std::size_t kMostBytesAtOnce = 16 * kReadBytes;
// Ends before the telegram does, since the end tells when it arrived.
constexpr double kRestedPart = 0.8;
constexpr double kShortestRest_s = 0.003;
// B1h is the longest answer to any request but those for scans.
constexpr double kLongestAnswerBytes = 160.0;

std::string hex(std::uint8_t byte) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "%02Xh", byte);
  return text.data();
}

std::string name_of(const LmsCommand& command) {
  const Bytes body = encode(command);
  std::string name = hex(body[0]);
  if ((body[0] == 0x20 || body[0] == 0x30) && body.size() > 1) name += " " + hex(body[1]);
  return name;
}

}  // namespace

LmsLink::LmsLink(ByteLink& port, const SickPatience& patience, const StopSignal& stop)
    : port_(port), patience_(patience), stop_(stop) {}

void LmsLink::flush() {
  port_.flush_input();
  decoder_.clear();
}

void LmsLink::set_baud(int baud) {
  port_.set_baud(baud);
  byte_s_ = 10.0 / baud;
  flush();
}

void LmsLink::tell(const LmsCommand& command) {
  port_.write(frame_telegram(0x00, encode(command)), stop_);
}

void LmsLink::rest(double longest_s) const {
  const double rest_s =
      std::min(longest_s, kRestedPart * static_cast<double>(decoder_.num_missing()) * byte_s_);
  if (rests_ && rest_s >= kShortestRest_s) stop_.sleep(rest_s);
}

/// Feeds the decoder what the port has, waiting for it. What lies in the port behind a large piece belongs to
/// the same moment: it is read along, so that its telegrams are seen to have arrived together.
bool LmsLink::read(double timeout_s) {
  std::array<std::uint8_t, kReadBytes> buffer{};
  std::size_t num_read = 0;
  std::size_t count = port_.read(buffer, timeout_s, stop_);
  for (; count > 0; count = port_.read(buffer, 0.0, stop_)) {
    last_read_s_ = steady_now_s();
    decoder_.feed(ByteView(buffer).first(count), last_read_s_);
    num_read += count;
    if (count < kLargePieceBytes || num_read >= kMostBytesAtOnce) break;
  }
  return num_read > 0;
}

bool LmsLink::next_item(WireItem& item, double deadline_s) {
  while (!decoder_.next(item)) {
    const double left_s = deadline_s - steady_now_s();
    if (left_s < 0.0) return false;
    rest(std::min(left_s, kLongestRead_s));
    if (!read(std::min(left_s, kLongestRead_s))) decoder_.expire(steady_now_s());
  }
  return true;
}

bool LmsLink::next_telegram(WireItem& item, double timeout_s, double& arrival_s) {
  const double deadline_s = steady_now_s() + timeout_s;
  while (next_item(item, deadline_s)) {
    arrival_s = last_read_s_;
    if (item.kind == WireItem::Kind::kTelegram) return true;
    // Garbage may be one long row of acknowledgements.
    if (steady_now_s() > deadline_s) return false;
  }
  return false;
}

/// Until when an answer is waited for: a while for its first sign, and longer once there was one.
struct LmsLink::Wait {
  std::size_t index = 0;  // of the answer among the replies
  double start_s = 0.0;
  double first_sign_s = 0.0;
  double reply_s = 0.0;
  double deadline_s = 0.0;
  std::int64_t garbage_at_ack = 0;

  /// Looked at often, so that a false acknowledgement does not hold up the probe of a wrong baud for long.
  double next_look_s() const { return std::min(deadline_s, std::max(first_sign_s, steady_now_s()) + 0.1); }

  bool is_noise(std::int64_t num_garbage) const {
    return num_garbage - garbage_at_ack > kMostGarbageAfterAck;
  }

  void acknowledge(std::int64_t num_garbage) {
    garbage_at_ack = num_garbage;
    deadline_s = start_s + reply_s;
  }
};

/// Whether the telegram is the answer, or a refusal in its place.
bool LmsLink::is_answer(ByteView body, std::size_t index, std::optional<LmsReply>& reply) {
  auto stated = parse_reply(body);
  if (!stated) return false;
  const LmsReply& got = stated->reply;
  if (const auto* type = std::get_if<TypeReply>(&got); type != nullptr && type->is_power_on) {
    throw LmsReboot("the sensor started anew (" + type->text + ")");
  }
  if (got.index() != index && !std::holds_alternative<RefusedReply>(got)) return false;
  reply = std::move(stated->reply);
  return true;
}

/// What an item means for the wait; empty where it goes on.
std::optional<LmsLink::Try> LmsLink::judge(const WireItem& item, Wait& wait, std::optional<LmsReply>& reply) {
  const std::int64_t num_garbage = decoder_.counts().num_garbage_bytes;
  switch (item.kind) {
    case WireItem::Kind::kNakByte:
      if (!wait.is_noise(num_garbage)) return Try::kRejected;
      break;
    case WireItem::Kind::kAckByte:
      wait.acknowledge(num_garbage);
      break;
    case WireItem::Kind::kTelegram:
      if (is_answer(item.body, wait.index, reply)) return Try::kAnswered;
      break;
  }
  // Whatever goes on and on, and never answers.
  return steady_now_s() > wait.start_s + 2.0 * wait.reply_s ? std::optional(Try::kSilence) : std::nullopt;
}

LmsLink::Try LmsLink::wait_for_reply(std::size_t index, const Ask& how, std::optional<LmsReply>& reply) {
  Wait wait{.index = index, .start_s = steady_now_s()};
  wait.reply_s = how.reply_s > 0.0 ? how.reply_s : patience_.reply_s;
  // An acknowledgement may get lost, so the answer itself must have the time to arrive.
  const double sign_s =
      how.first_sign_s > 0.0 ? how.first_sign_s : patience_.ack_s + kLongestAnswerBytes * byte_s_;
  wait.deadline_s = wait.first_sign_s = wait.start_s + sign_s;
  wait.garbage_at_ack = decoder_.counts().num_garbage_bytes;
  WireItem item;
  while (true) {
    const bool has_item = next_item(item, wait.next_look_s());
    if (wait.is_noise(decoder_.counts().num_garbage_bytes)) wait.deadline_s = wait.first_sign_s;
    if (has_item) {
      if (const auto outcome = judge(item, wait, reply)) return *outcome;
    } else if (steady_now_s() >= wait.deadline_s) {
      return Try::kSilence;
    }
  }
}

LmsReply LmsLink::ask_for(const LmsCommand& command, std::size_t index, const Ask& how) {
  for (int i = 0; i < how.num_tries; ++i) {
    flush();
    tell(command);
    std::optional<LmsReply> reply;
    const Try outcome = wait_for_reply(index, how, reply);
    if (outcome == Try::kAnswered) {
      if (!std::holds_alternative<RefusedReply>(*reply)) return std::move(*reply);
      throw DeviceRefusal("the sensor refused command " + name_of(command) + " as illegal (92h)");
    }
    if (outcome == Try::kRejected) stop_.sleep(kPauseAfterNak_s);
  }
  throw SensorFault(SensorFault::Kind::kTimeout, "no answer to command " + name_of(command) + " in " +
                                                     std::to_string(how.num_tries) + " tries");
}

}  // namespace scanbed::hw
