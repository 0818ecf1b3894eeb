// SPDX-License-Identifier: MIT
#include "hw/sick/telegram_decoder.hpp"

#include "hw/sick/crc.hpp"

namespace scanbed::hw {
namespace {

constexpr std::size_t kHeadBytes = 5;  // STX, address, length, command

bool has_top_bit(std::uint8_t byte) {
  return (byte & 0x80) != 0;
}

}  // namespace

void TelegramDecoder::feed(ByteView bytes, double now_s) {
  if (bytes.empty()) return;
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(head_));
  head_ = 0;
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  last_feed_s_ = now_s;
}

/// Whether what is there of the first five bytes can start a telegram.
bool TelegramDecoder::has_good_head(ByteView rest) const {
  const bool is_sensor = talker_ == Talker::kSensor;
  if (rest.size() > 1 && has_top_bit(rest[1]) != is_sensor) return false;
  if (rest.size() >= 4 && (read_word(rest, 2) < 1 || read_word(rest, 2) > kMaxBodyBytes)) return false;
  // A host may send a command that there is not; it is to be told so.
  return rest.size() < kHeadBytes || !is_sensor || has_top_bit(rest[4]);
}

TelegramDecoder::Look TelegramDecoder::look() {
  const ByteView rest = ByteView(buffer_).subspan(head_);
  if (!has_good_head(rest)) return Look::kNone;
  if (rest.size() < kHeadBytes) return Look::kIncomplete;
  const std::size_t checked = read_word(rest, 2) + kFrameBytes - 2;
  if (rest.size() < checked + 2) return Look::kIncomplete;
  if (lms_crc(rest.first(checked)) == read_word(rest, checked)) return Look::kTelegram;
  ++counts_.num_crc_errors;
  return Look::kNone;
}

void TelegramDecoder::skip_one() {
  ++head_;
  ++counts_.num_garbage_bytes;
}

bool TelegramDecoder::next(WireItem& item) {
  while (head_ < buffer_.size()) {
    const std::uint8_t first = buffer_[head_];
    if (first == kAcknowledge || first == kNotAcknowledge) {
      ++head_;
      item = {.kind = first == kAcknowledge ? WireItem::Kind::kAckByte : WireItem::Kind::kNakByte,
              .address = 0,
              .body = {}};
      return true;
    }
    const Look what = first == kStx ? look() : Look::kNone;
    if (what == Look::kIncomplete) return false;
    if (what == Look::kTelegram) {
      const ByteView rest = ByteView(buffer_).subspan(head_);
      item = {
          .kind = WireItem::Kind::kTelegram, .address = rest[1], .body = rest.subspan(4, read_word(rest, 2))};
      head_ += item.body.size() + kFrameBytes;
      item.num_bytes_behind = buffer_.size() - head_;
      ++counts_.num_telegrams;
      return true;
    }
    skip_one();
  }
  return false;
}

void TelegramDecoder::expire(double now_s) {
  if (!is_waiting() || now_s - last_feed_s_ < expiry_s_) return;
  skip_one();
  ++counts_.num_expired;
}

std::size_t TelegramDecoder::num_missing() const {
  const ByteView rest = ByteView(buffer_).subspan(head_);
  if (rest.size() < kHeadBytes || rest[0] != kStx || !has_good_head(rest)) return 0;
  const std::size_t whole = read_word(rest, 2) + kFrameBytes;
  return whole > rest.size() ? whole - rest.size() : 0;
}

void TelegramDecoder::clear() {
  buffer_.clear();
  head_ = 0;
}

}  // namespace scanbed::hw
