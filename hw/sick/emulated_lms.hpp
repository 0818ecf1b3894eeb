// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <random>
#include <vector>

#include "hw/sick/emulator_options.hpp"
#include "hw/sick/lms_command.hpp"
#include "hw/sick/lms_reply.hpp"
#include "hw/sick/scan_feed.hpp"
#include "hw/sick/scan_telegram.hpp"
#include "hw/sick/telegram_decoder.hpp"

namespace scanbed::hw {

struct EmulatorCounts {
  std::int64_t num_requests = 0;       ///< understood
  std::int64_t num_eeprom_writes = 0;  ///< configurations written
  std::int64_t num_faults = 0;         ///< that came into effect
};

/// An LMS 200 without a wire: bytes in, bytes out, at times that the caller gives. Nothing waits in here.
///
/// Modes, password, bauds, variants, configuration memory, diagnostics and refusals are those of the
/// manufacturer's listing. Not emulated, and refused with 92h or result 1: sub-ranges of the stream, request
/// 7Bh and fields, whose replies were not at hand.
/// @par Source  SICK, "Telegrams for Configuring and Operating the LMS 2xx"; rates at which scans are left
/// out
///              at slow bauds: its table of data transmission rates.
class EmulatedLms {
 public:
  /// @throws InputError where the options do not validate.
  EmulatedLms(const EmulatorOptions& options, ScanSupply source, ScanFeed::Observer observer);

  /// Hears what a host sent. At another baud than its own it hears nothing.
  void receive(ByteView bytes, int host_baud, double now_s);

  /// Appends what has gone over the wire since the last call; to a host at another baud, gibberish.
  void run(double now_s, int host_baud, Bytes& out);

  /// When run() will next have something to send; infinity where only a request can bring that about.
  double next_event_s() const;

  /// Lets a fault happen at the next run() or receive(), beside those of the options.
  void inject(LmsFaultKind fault) { injected_.push_back(fault); }

  /// True once after a fault took the port away: the caller unplugs it for options.unplug_s.
  bool take_unplug();

  int baud() const { return baud_; }
  LmsMode mode() const { return mode_; }
  const EmulatorCounts& counts() const { return counts_; }

 private:
  struct Transmission {
    double start_s = 0.0;
    Bytes bytes;
    std::size_t num_sent = 0;
    bool is_stream = false;
    int baud_after = 0;  // the baud to change to when it is out; 0: none
  };
  struct Answerer;

  bool is_deaf(double now_s) const;
  void answer(const WireItem& item, double now_s);
  void acknowledge(std::uint8_t byte, double now_s);
  void reply(const LmsReply& content, double delay_s);
  void reply_scan(ScanTelegram telegram);
  void send(Bytes bytes, double delay_s, bool is_stream = false);
  void start_boot(double now_s);
  void start_faults(double now_s);
  void start_fault(LmsFaultKind kind, double now_s);
  void send_due(double now_s, int host_baud, Bytes& out);
  bool is_streaming() const;
  void stream(double now_s);
  ScanTelegram next_telegram();
  void load_scan(bool is_partial);
  Bytes damaged(Bytes telegram);
  double scan_period_s(std::size_t num_bytes, bool is_partial) const;
  double byte_s() const;
  double delay(double real_s) const { return options_.is_paced ? real_s : 0.0; }
  int random_below(int bound);
  LmsStatusByte status();

  EmulatorOptions options_;
  ScanFeed feed_;
  TelegramDecoder decoder_{TelegramDecoder::Talker::kHost};
  std::deque<Transmission> queue_;
  EmulatorCounts counts_;
  std::mt19937_64 chance_;

  // What a reboot brings back.
  int baud_;
  LmsMode mode_ = LmsMode::kOnRequest;
  // What it does not.
  LmsVariant variant_;
  LmsConfiguration configuration_;
  int power_on_baud_;

  double start_s_ = 0.0;
  double boot_end_s_ = -1.0;  // < 0: up
  double silent_until_s_ = -1.0;
  double next_scan_s_ = 0.0;
  double wire_free_s_ = 0.0;  // when the last queued byte is out
  std::size_t next_fault_ = 0;
  std::vector<LmsFaultKind> injected_;
  std::uint8_t scan_index_ = 0;
  std::uint8_t telegram_index_ = 0;
  bool feed_is_partial_ = false;
  bool has_started_ = false;
  int next_partial_ = 0;
  std::vector<std::uint16_t> turn_words_;  // of the scan whose turns are being sent

  // Faults that wait for their occasion.
  bool has_garbage_ = false;
  bool has_half_ = false;
  bool has_flip_ = false;
  bool has_blind_pair_ = false;
  bool has_nak_ = false;
  bool has_miss_ = false;
  bool has_unplug_ = false;
  int num_refusals_ = 0;
  int num_polluted_ = 0;
};

}  // namespace scanbed::hw
