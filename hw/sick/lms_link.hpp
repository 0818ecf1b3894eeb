// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/errors/sensor_fault.hpp"
#include "hw/serial/byte_link.hpp"
#include "hw/serial/device_refusal.hpp"
#include "hw/sick/lms_command.hpp"
#include "hw/sick/lms_reply.hpp"
#include "hw/sick/sick_options.hpp"
#include "hw/sick/telegram_decoder.hpp"

namespace scanbed::hw {

/// The sensor started anew while it was spoken to: all that was set is gone.
class LmsReboot : public SensorFault {
 public:
  explicit LmsReboot(const std::string& what) : SensorFault(Kind::kDisconnected, what) {}
};

/// Requests to an LMS and their answers. No wait is without a bound, and each ends when the signal is given.
class LmsLink {
 public:
  /// @param port, stop  must outlive this.
  LmsLink(ByteLink& port, const SickPatience& patience, const StopSignal& stop);

  struct Ask {
    int num_tries = 3;
    double first_sign_s = 0.0;  ///< 0: patience.ack_s, and the time of an answer on the wire
    double reply_s = 0.0;       ///< 0: patience.reply_s
  };

  /// Sends a command and waits for its own answer; telegrams of other kinds that come before it are dropped.
  /// NAK and silence are answered by asking again.
  /// @throws DeviceRefusal where the answer is 92h; LmsReboot where it is the text of power-on.
  /// @throws SensorFault kTimeout where there is none; kDisconnected where the port is lost. Stopped.
  template <typename Reply>
  Reply ask(const LmsCommand& command, const Ask& how) {
    return std::get<Reply>(ask_for(command, LmsReply(Reply{}).index(), how));
  }
  template <typename Reply>
  Reply ask(const LmsCommand& command) {
    return ask<Reply>(command, Ask{});
  }

  /// Sends a command and waits for nothing.
  void tell(const LmsCommand& command);

  /// Changes the port's own baud and forgets what arrived at the old one.
  void set_baud(int baud);

  /// Waits for the next telegram; false where `timeout_s` passes first. `arrival_s` is when it was read
  /// (steady_now_s); what was read along is told by the item's bytes behind.
  bool next_telegram(WireItem& item, double timeout_s, double& arrival_s);

  /// From now on sleeps while most of a telegram whose beginning is there arrives, so that it is not woken
  /// for each few bytes. Of no use where bytes come faster than the baud says.
  void rest_in_telegrams() { rests_ = true; }

  /// From now on waits this long for the rest of a telegram: for an emulator that may stand still in one.
  void wait_in_telegrams(double gap_s) { decoder_.set_expiry(gap_s); }

  void flush();

  const DecoderCounts& decoder_counts() const { return decoder_.counts(); }
  const StopSignal& stop() const { return stop_; }
  const SickPatience& patience() const { return patience_; }

 private:
  enum class Try { kAnswered, kRejected, kSilence };
  LmsReply ask_for(const LmsCommand& command, std::size_t index, const Ask& how);
  struct Wait;
  static bool is_answer(ByteView body, std::size_t index, std::optional<LmsReply>& reply);
  std::optional<Try> judge(const WireItem& item, Wait& wait, std::optional<LmsReply>& reply);
  Try wait_for_reply(std::size_t index, const Ask& how, std::optional<LmsReply>& reply);
  bool read(double timeout_s);
  bool next_item(WireItem& item, double deadline_s);
  void rest(double longest_s) const;

  ByteLink& port_;
  SickPatience patience_;
  const StopSignal& stop_;
  TelegramDecoder decoder_{TelegramDecoder::Talker::kSensor};
  double last_read_s_ = 0.0;
  double byte_s_ = 0.0;  // on the wire; 0: not known
  bool rests_ = false;
};

}  // namespace scanbed::hw
