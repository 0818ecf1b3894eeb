// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

namespace scanbed::tests {

/// What one LMS does otherwise than the next, within what the protocol leaves open.
struct ForeignHabits {
  int power_on_baud = 38400;
  std::vector<int> bauds = {9600, 19200, 38400, 500000};  ///< others are refused
  std::uint8_t reply_address = 0x80;
  std::uint8_t status = 0x10;
  bool acknowledges = true;
  bool acknowledges_late = false;     ///< behind the reply
  bool knows_diagnostics = true;      ///< 32h and 3Ah; else 92h
  bool talks_at_other_bauds = false;  ///< noise where the host's baud is another
  bool says_power_on = false;         ///< 90h as soon as somebody speaks
  bool streams_at_power_on = false;
  bool streams_before_reply = false;  ///< a scan between the ACK of 20h 24h and its A0
  bool breaks_off = false;            ///< a request ends the telegram being sent in its middle
  bool changes_other_bytes = false;   ///< of a configuration that is written: those without a meaning here
  std::size_t configuration_bytes = 34;
  std::string password = "SICK_LMS";
  bool sends_indices = false;
  bool is_in_millimetres = true;  ///< as it comes
  std::uint8_t measuring_mode = 0;
  double ack_s = 0.0;                     ///< from request to ACK
  double reply_s = 0.0;                   ///< from ACK to reply
  double mode_s = 0.0;                    ///< the same where the mode changes
  double write_s = 0.0;                   ///< the same where the configuration is written
  std::size_t piece_bytes = 0;            ///< written at a time; 0: all
  double piece_s = 0.0;                   ///< between two pieces
  bool sends_turns_out_of_order = false;  ///< of 0.25 degrees: .00, .50, .25, .75
};

enum class ForeignFault {
  kNone,
  kNak,
  kDeaf,     ///< the next request is not heard
  kLostAck,  ///< the next request is answered without ACK
  kFlip,
  kHalf,
  kGarbage,        ///< with the head of a long telegram in it
  kBlindHeadPair,  ///< two bits of the number of values that the check word does not miss
  kOtherUnit,      ///< a whole telegram that the configuration does not fit to
  kShort,          ///< fewer values than configured, with a good check word
  kSilence,
  kReboot,  ///< and back at the baud of power-on
  kUnplug,
};

/// A second LMS 2xx at a pseudo-terminal, written from the protocol alone: it shares no code with hw/, so
/// that a mistake there does not hide behind its own mirror image. It measures numbered_steps(). One thread,
/// no pacing but that of the habits.
class ForeignLms {
 public:
  explicit ForeignLms(const ForeignHabits& habits);
  ~ForeignLms();
  ForeignLms(const ForeignLms&) = delete;
  ForeignLms& operator=(const ForeignLms&) = delete;

  const std::string& port() const { return link_; }

  /// Goes wrong at the next occasion.
  void arm(ForeignFault fault) { fault_ = fault; }

  /// Whether that has come; waits for it, long but not for ever.
  bool has_failed() const;

  std::int64_t num_scans() const { return num_scans_.load(); }
  int num_writes() const { return num_writes_.load(); }  ///< of the EEPROM
  int baud() const { return baud_.load(); }
  bool is_streaming() const { return mode_.load() == 0x24 || mode_.load() == 0x2A; }

 private:
  using Bytes = std::vector<std::uint8_t>;

  void serve();
  void plug();
  void unplug();
  void hear();
  bool take_request();
  void answer(const Bytes& body);
  void answer_mode(const Bytes& body);
  void answer_baud(int baud);
  void answer_variant(const Bytes& body);
  void answer_write(const Bytes& body);
  void acknowledge();
  void reply(const Bytes& body, double after_s);
  void refuse() { reply({0x92}, habits_.reply_s); }
  Bytes account() const;
  void stream();
  Bytes next_scan();
  Bytes noise();
  void go_wrong_in_stream(Bytes& telegram);
  void reboot();
  void put(const Bytes& bytes, bool can_be_broken_off);
  bool take(ForeignFault fault);
  int host_baud() const;
  void pause(double duration_s) const;
  Bytes framed(const Bytes& body, bool with_status) const;

  ForeignHabits habits_;
  std::string link_;
  int master_ = -1;
  int slave_ = -1;
  Bytes heard_;
  bool is_fresh_ = true;
  int fov_deg_ = 180;
  int resolution_cdeg_ = 50;
  Bytes configuration_;
  int turn_ = 0;
  std::uint32_t chance_ = 1;
  std::atomic<int> baud_;
  std::atomic<int> mode_{0x25};
  std::atomic<std::int64_t> num_scans_{0};
  std::atomic<int> num_writes_{0};
  std::atomic<ForeignFault> fault_{ForeignFault::kNone};
  std::atomic<bool> is_over_{false};
  std::thread thread_;
};

}  // namespace scanbed::tests
