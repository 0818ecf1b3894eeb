// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hw/sick/telegram.hpp"

namespace scanbed::hw {

/// What a decoder found next on the wire.
struct WireItem {
  enum class Kind { kTelegram, kAckByte, kNakByte };
  Kind kind = Kind::kTelegram;
  std::uint8_t address = 0;  ///< of a telegram
  ByteView body;             ///< of a telegram: command, data, status; valid until the next feed() or clear()
  std::size_t num_bytes_behind = 0;  ///< a telegram's, that were fed and not looked at yet
};

/// Counted since construction.
struct DecoderCounts {
  std::int64_t num_telegrams = 0;
  std::int64_t num_garbage_bytes = 0;  ///< that belong to no telegram and are no ACK or NAK
  std::int64_t num_crc_errors = 0;     ///< places that looked like a telegram but for the check word
  std::int64_t num_expired = 0;        ///< places that looked like a telegram whose rest never came
};

/// Finds telegrams in a stream of bytes, whatever stands between them. Where what looked like a telegram is
/// none, one byte is skipped and the rest is looked at again: a true telegram inside it is found.
/// ACK and NAK may also stand inside garbage: they are hints, the checked telegram is the answer.
class TelegramDecoder {
 public:
  enum class Talker { kHost, kSensor };

  /// A telegram whose rest stays away this long is given up: gaps inside one are up to 14 ms, and adapters
  /// add some.
  static constexpr double kExpiry_s = 0.08;

  /// @param talker  whose bytes these are: a sensor's addresses and commands have bit 7 set, a host's
  ///                addresses have not.
  explicit TelegramDecoder(Talker talker) : talker_(talker) {}

  void feed(ByteView bytes, double now_s);

  /// Finds the next item; false where none is complete yet.
  bool next(WireItem& item);

  /// Gives up a telegram that has stood still for the time of expiry; next() then looks at what lies behind
  /// its start.
  void expire(double now_s);

  /// In place of kExpiry_s.
  void set_expiry(double expiry_s) { expiry_s_ = expiry_s; }

  /// Whether the start of a telegram waits for its rest.
  bool is_waiting() const { return head_ < buffer_.size(); }

  /// Bytes that the telegram whose start waits is still short of; 0 where its length is not there yet either.
  std::size_t num_missing() const;

  /// Forgets what waits.
  void clear();

  const DecoderCounts& counts() const { return counts_; }

 private:
  enum class Look { kTelegram, kIncomplete, kNone };
  Look look();
  bool has_good_head(ByteView rest) const;
  void skip_one();

  Talker talker_;
  Bytes buffer_;
  std::size_t head_ = 0;  // of what was not looked at yet
  double expiry_s_ = kExpiry_s;
  double last_feed_s_ = 0.0;
  DecoderCounts counts_;
};

}  // namespace scanbed::hw
