// SPDX-License-Identifier: MIT
#include "hw/sick/emulated_lms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace scanbed::hw {
namespace {

constexpr double kNever_s = std::numeric_limits<double>::infinity();
constexpr double kAckDelay_s = 0.002;
constexpr double kReplyDelay_s = 0.005;
constexpr int kNumPolluted = 10;

// What a receiver at the wrong baud makes of a byte: nothing like it, and less of it.
void append_gibberish(Bytes& out, std::uint8_t byte) {
  if ((byte & 0x03) == 0x03) return;
  out.push_back(static_cast<std::uint8_t>((byte * 0x4D + 0x35) | 0x80));
}

EmulatorOptions validated(EmulatorOptions options) {
  options.validate();
  std::stable_sort(options.faults.begin(), options.faults.end(),
                   [](const LmsFault& a, const LmsFault& b) { return a.at_s < b.at_s; });
  return options;
}

}  // namespace

EmulatedLms::EmulatedLms(const EmulatorOptions& options, ScanSupply source, ScanFeed::Observer observer)
    : options_(validated(options)),
      feed_(std::move(source), std::move(observer)),
      chance_(options.seed),
      baud_(options.power_on_baud),
      variant_(options.variant),
      configuration_(options.configuration),
      power_on_baud_(options.power_on_baud) {}

int EmulatedLms::random_below(int bound) {
  return static_cast<int>(chance_() % static_cast<std::uint64_t>(bound));
}

double EmulatedLms::byte_s() const {
  return options_.is_paced ? 10.0 / baud_ : 0.0;
}

LmsStatusByte EmulatedLms::status() {
  if (num_polluted_ == 0) return {};
  --num_polluted_;
  return {0x92};  // pollution, and a warning
}

bool EmulatedLms::is_deaf(double now_s) const {
  return boot_end_s_ >= 0.0 || now_s < silent_until_s_;
}

bool EmulatedLms::is_streaming() const {
  return boot_end_s_ < 0.0 && (mode_ == LmsMode::kStream || mode_ == LmsMode::kStreamPartial);
}

bool EmulatedLms::take_unplug() {
  return std::exchange(has_unplug_, false);
}

/// Puts bytes behind those that wait, `delay_s` after the last of them.
void EmulatedLms::send(Bytes bytes, double delay_s, bool is_stream) {
  Transmission transmission;
  transmission.start_s = wire_free_s_ + delay(delay_s);
  transmission.bytes = std::move(bytes);
  transmission.is_stream = is_stream;
  wire_free_s_ = transmission.start_s + static_cast<double>(transmission.bytes.size()) * byte_s();
  queue_.push_back(std::move(transmission));
}

void EmulatedLms::acknowledge(std::uint8_t byte, double now_s) {
  // A request breaks off what the stream was sending.
  while (!queue_.empty() && queue_.back().is_stream) queue_.pop_back();
  wire_free_s_ = now_s;
  for (const Transmission& waiting : queue_) {
    wire_free_s_ =
        std::max(wire_free_s_, waiting.start_s + static_cast<double>(waiting.bytes.size()) * byte_s());
  }
  send({byte}, kAckDelay_s);
}

void EmulatedLms::reply(const LmsReply& content, double delay_s) {
  send(frame_telegram(kReplyAddress | options_.address, encode(content, status())), delay_s);
}

void EmulatedLms::reply_scan(ScanTelegram telegram) {
  telegram.status = status();
  send(frame_telegram(kReplyAddress | options_.address, encode(telegram)), kReplyDelay_s);
}

/// Answers each command, already acknowledged.
struct EmulatedLms::Answerer {
  EmulatedLms& lms;
  double now_s;

  void refuse() const { lms.reply(RefusedReply{}, kReplyDelay_s); }

  void operator()(const ResetCommand&) const {
    lms.reply(ResetReply{}, kReplyDelay_s);
    lms.start_boot(lms.wire_free_s_);
  }

  void operator()(const SetModeCommand& command) const {
    const bool needs_password = command.mode == LmsMode::kInstallation || command.mode == LmsMode::kTest;
    const bool is_unlucky = lms.num_refusals_ > 0;
    if (is_unlucky) --lms.num_refusals_;
    const bool is_refused = is_unlucky || (needs_password && !command.has_password);
    if (!is_refused) {
      lms.mode_ = command.mode;
      lms.next_partial_ = 0;
    }
    lms.reply(ModeReply{static_cast<std::uint8_t>(is_refused ? 1 : 0)}, lms.options_.mode_switch_s);
    lms.next_scan_s_ = lms.wire_free_s_;
  }

  void operator()(const SetBaudCommand& command) const {
    lms.reply(ModeReply{0}, lms.options_.mode_switch_s);
    lms.queue_.back().baud_after = command.baud;
    lms.next_scan_s_ = lms.wire_free_s_ + kReplyDelay_s;
  }

  void operator()(const StreamSubrangeCommand&) const { lms.reply(ModeReply{1}, lms.options_.mode_switch_s); }

  void operator()(const RequestScanCommand& command) const {
    const bool is_partial = command.what == RequestScanCommand::What::kPartials;
    lms.load_scan(is_partial);
    lms.next_partial_ = 0;
    for (int i = 0; i < (is_partial ? 4 : 1); ++i) lms.reply_scan(lms.next_telegram());
  }

  void operator()(const RequestCommand& command) const {
    switch (command.what) {
      case RequestCommand::What::kStatus:
        return lms.reply(account(), kReplyDelay_s);
      case RequestCommand::What::kErrors:
        return lms.reply(errors(), kReplyDelay_s);
      case RequestCommand::What::kType:
        return lms.reply(TypeReply{lms.options_.type}, kReplyDelay_s);
      case RequestCommand::What::kConfiguration:
        return lms.reply(ConfigurationReply{lms.configuration_}, kReplyDelay_s);
      case RequestCommand::What::kOther:
        return refuse();
    }
  }

  void operator()(const SetVariantCommand& command) const {
    const bool is_done = command.variant.is_offered();
    if (is_done) lms.variant_ = command.variant;
    lms.feed_is_partial_ = true;  // whatever it was, it is not for this variant
    lms.load_scan(false);
    lms.reply(VariantReply{is_done, lms.variant_}, lms.options_.mode_switch_s);
  }

  void operator()(const SetPermanentBaudCommand& command) const {
    if (lms.mode_ != LmsMode::kInstallation) return refuse();
    lms.power_on_baud_ = command.is_permanent ? lms.baud_ : 9600;
    lms.reply(PermanentBaudReply{}, kReplyDelay_s);
  }

  void operator()(const WriteConfigurationCommand& command) const {
    if (lms.mode_ != LmsMode::kInstallation) return refuse();
    const LmsConfiguration& wanted = command.configuration;
    const bool is_done =
        wanted.bytes().size() == lms.configuration_.bytes().size() && wanted.bytes()[6] <= 1 &&
        (lms_word_format(wanted.measuring_mode()).has_value() || wanted.measuring_mode() == 0x3F);
    if (is_done) {
      lms.configuration_ = wanted;
      ++lms.counts_.num_eeprom_writes;
      lms.feed_is_partial_ = true;
      lms.load_scan(false);
    }
    lms.reply(WrittenReply{is_done, lms.configuration_}, lms.options_.write_s);
  }

  StatusReply account() const {
    StatusReply reply;
    reply.mode = lms.mode_;
    reply.measuring_mode = lms.configuration_.measuring_mode();
    reply.variant = lms.variant_;
    reply.baud = lms.baud_;
    reply.has_permanent_baud = lms.power_on_baud_ != 9600;
    reply.address = lms.options_.address;
    reply.unit = lms.configuration_.unit();
    return reply;
  }

  ErrorsReply errors() const {
    ErrorsReply reply;
    if (lms.num_polluted_ > 0) reply.entries.push_back({2, 17});
    return reply;
  }
};

void EmulatedLms::answer(const WireItem& item, double now_s) {
  if (item.address != 0 && item.address != options_.address) return;
  if (std::exchange(has_miss_, false)) return;
  if (std::exchange(has_nak_, false)) return acknowledge(kNotAcknowledge, now_s);
  acknowledge(kAcknowledge, now_s);
  const auto command = parse_command(item.body);
  if (!command) return reply(RefusedReply{}, kReplyDelay_s);
  ++counts_.num_requests;
  std::visit(Answerer{*this, now_s}, *command);
}

void EmulatedLms::receive(ByteView bytes, int host_baud, double now_s) {
  start_faults(now_s);
  if (is_deaf(now_s) || host_baud != baud_) return;
  decoder_.expire(now_s);
  const std::int64_t num_bad = decoder_.counts().num_crc_errors;
  decoder_.feed(bytes, now_s);
  bool has_answered = false;
  for (WireItem item; decoder_.next(item);) {
    if (item.kind != WireItem::Kind::kTelegram) continue;
    has_answered = true;
    answer(item, now_s);
  }
  if (!has_answered && decoder_.counts().num_crc_errors > num_bad) acknowledge(kNotAcknowledge, now_s);
}

void EmulatedLms::start_boot(double now_s) {
  boot_end_s_ = now_s + (options_.is_paced ? options_.boot_s : std::min(options_.boot_s, 0.02));
  mode_ = LmsMode::kOnRequest;
  if (!queue_.empty()) {
    queue_.back().baud_after = power_on_baud_;
  } else {
    baud_ = power_on_baud_;
  }
  decoder_.clear();
}

void EmulatedLms::start_fault(LmsFaultKind kind, double now_s) {
  ++counts_.num_faults;
  switch (kind) {
    case LmsFaultKind::kGarbage:
      has_garbage_ = true;
      break;
    case LmsFaultKind::kHalf:
      has_half_ = true;
      break;
    case LmsFaultKind::kFlip:
      has_flip_ = true;
      break;
    case LmsFaultKind::kBlindPair:
      has_blind_pair_ = true;
      break;
    case LmsFaultKind::kNak:
      has_nak_ = true;
      break;
    case LmsFaultKind::kMiss:
      has_miss_ = true;
      break;
    case LmsFaultKind::kRefuse:
      ++num_refusals_;
      break;
    case LmsFaultKind::kSilence:
      queue_.clear();
      silent_until_s_ = now_s + options_.silence_s;
      break;
    case LmsFaultKind::kReboot:
      queue_.clear();
      start_boot(now_s);
      break;
    case LmsFaultKind::kUnplug:
      has_unplug_ = true;
      break;
    case LmsFaultKind::kPollution:
      num_polluted_ = kNumPolluted;
      break;
  }
}

void EmulatedLms::start_faults(double now_s) {
  if (!std::exchange(has_started_, true)) start_s_ = now_s;
  while (next_fault_ < options_.faults.size() && options_.faults[next_fault_].at_s <= now_s - start_s_) {
    start_fault(options_.faults[next_fault_++].kind, now_s);
  }
  for (const LmsFaultKind fault : std::exchange(injected_, {})) start_fault(fault, now_s);
}

/// Makes the feed give what the stream, or a single answer, is to carry.
void EmulatedLms::load_scan(bool is_partial) {
  if (feed_.is_started() && feed_is_partial_ == is_partial) return;
  feed_is_partial_ = is_partial;
  const auto format = lms_word_format(configuration_.measuring_mode());
  feed_.restart({is_partial ? LmsVariant{180, 25} : variant_, configuration_.unit()},
                format.value_or(LmsWordFormat{}));
}

ScanTelegram EmulatedLms::next_telegram() {
  ScanTelegram telegram;
  telegram.unit = configuration_.unit();
  telegram.is_partial = feed_is_partial_;
  if (feed_is_partial_) {
    if (next_partial_ == 0) turn_words_ = feed_.next();
    telegram.partial = next_partial_;
    for (auto i = static_cast<std::size_t>(next_partial_); i < turn_words_.size(); i += 4) {
      telegram.words.push_back(turn_words_[i]);
    }
    next_partial_ = (next_partial_ + 1) % 4;
  } else {
    telegram.words = feed_.next();
  }
  if (configuration_.sends_indices()) telegram.indices = {{scan_index_, telegram_index_}};
  ++telegram_index_;
  if (!feed_is_partial_ || next_partial_ == 0) ++scan_index_;
  return telegram;
}

/// How long the sensor takes from one telegram of the stream to the next: whole scans, and at bauds that do
/// not carry every scan one more than the telegram's own time on the wire.
double EmulatedLms::scan_period_s(std::size_t num_bytes, bool is_partial) const {
  const double own_s = kLmsRotation_s * (is_partial ? 1 : variant_.num_rotations());
  const double num_missed = std::floor(static_cast<double>(num_bytes) * byte_s() / own_s);
  // The turns of an interlaced scan come in their order, so a multiple of four is left out.
  const double num_left_out = is_partial ? 4.0 * std::ceil((num_missed + 1.0) / 4.0) : num_missed + 1.0;
  return own_s * (num_missed < 1.0 ? 1.0 : num_left_out + 1.0);
}

Bytes EmulatedLms::damaged(Bytes telegram) {
  if (std::exchange(has_flip_, false)) {
    telegram[static_cast<std::size_t>(random_below(static_cast<int>(telegram.size())))] ^=
        static_cast<std::uint8_t>(1 << random_below(8));
  }
  if (std::exchange(has_blind_pair_, false)) {
    const std::size_t at = 4U + static_cast<std::size_t>(random_below(2));
    const int bit = random_below(7);
    telegram[at] ^= static_cast<std::uint8_t>(1 << bit);
    telegram[at + 1] ^= static_cast<std::uint8_t>(2 << bit);
  }
  if (std::exchange(has_half_, false)) telegram.resize(telegram.size() / 2);
  if (std::exchange(has_garbage_, false)) {
    Bytes garbage(static_cast<std::size_t>(1 + random_below(60)));
    for (std::uint8_t& byte : garbage) byte = static_cast<std::uint8_t>(random_below(256));
    garbage[0] = kStx;
    telegram.insert(telegram.begin(), garbage.begin(), garbage.end());
  }
  return telegram;
}

void EmulatedLms::stream(double now_s) {
  load_scan(mode_ == LmsMode::kStreamPartial);
  ScanTelegram content = next_telegram();
  content.status = status();
  Bytes telegram = frame_telegram(kReplyAddress | options_.address, encode(content));
  const double period_s = options_.is_paced ? scan_period_s(telegram.size(), content.is_partial) : 0.0;
  wire_free_s_ = std::max(wire_free_s_, next_scan_s_);
  send(damaged(std::move(telegram)), 0.0, true);
  // A host that stood still does not get all the scans of the meantime at once.
  next_scan_s_ = std::max(next_scan_s_ + period_s, now_s - period_s);
}

void EmulatedLms::send_due(double now_s, int host_baud, Bytes& out) {
  while (!queue_.empty() && queue_.front().start_s <= now_s) {
    Transmission& first = queue_.front();
    const double num_due = byte_s() > 0.0 ? (now_s - first.start_s) / byte_s() : kNever_s;
    const auto due = static_cast<std::size_t>(std::min(num_due, static_cast<double>(first.bytes.size())));
    for (; first.num_sent < due; ++first.num_sent) {
      const std::uint8_t byte = first.bytes[first.num_sent];
      if (host_baud == baud_) {
        out.push_back(byte);
      } else {
        append_gibberish(out, byte);
      }
    }
    if (first.num_sent < first.bytes.size()) return;
    const int baud_after = first.baud_after;
    queue_.pop_front();
    // The host has not read the last bytes yet, and reads them at the old baud: nothing more for now.
    if (baud_after != 0) {
      baud_ = baud_after;
      return;
    }
  }
}

void EmulatedLms::run(double now_s, int host_baud, Bytes& out) {
  start_faults(now_s);
  if (now_s < silent_until_s_) return;
  if (boot_end_s_ >= 0.0 && now_s >= boot_end_s_ && queue_.empty()) {
    boot_end_s_ = -1.0;
    wire_free_s_ = now_s;
    reply(TypeReply{options_.type, true}, 0.0);
  }
  send_due(now_s, host_baud, out);
  if (!is_streaming() || !queue_.empty()) return;
  if (now_s < next_scan_s_) return;
  stream(now_s);
  send_due(now_s, host_baud, out);
}

double EmulatedLms::next_event_s() const {
  double next_s = next_fault_ < options_.faults.size() && has_started_
                      ? start_s_ + options_.faults[next_fault_].at_s
                      : kNever_s;
  const auto sooner = [&](double at_s) { next_s = std::min(next_s, std::max(at_s, silent_until_s_)); };
  if (boot_end_s_ >= 0.0) sooner(boot_end_s_);
  if (!queue_.empty()) {
    const Transmission& first = queue_.front();
    sooner(first.start_s + static_cast<double>(first.num_sent + 1) * byte_s());
  } else if (is_streaming()) {
    sooner(next_scan_s_);
  }
  return next_s;
}

}  // namespace scanbed::hw
