// SPDX-License-Identifier: MIT
#include "hw/sick/scan_telegram.hpp"

#include "core/errors/ensure.hpp"
#include "hw/sick/telegram.hpp"

namespace scanbed::hw {
namespace {

constexpr std::uint8_t kMeasuredValues = 0xB0;
constexpr unsigned kCountMask = 0x03FF;
constexpr unsigned kReservedBit = 0x0400;
constexpr unsigned kPartialShift = 11;
constexpr unsigned kPartialFlag = 0x2000;
constexpr unsigned kUnitShift = 14;
constexpr std::size_t kWordsAt = 3;

unsigned header_of(const ScanTelegram& telegram) {
  const unsigned unit = telegram.unit == RangeUnit::kMillimetre ? 1 : 0;
  return static_cast<unsigned>(telegram.words.size()) |
         static_cast<unsigned>(telegram.partial) << kPartialShift |
         (telegram.is_partial ? kPartialFlag : 0U) | unit << kUnitShift;
}

}  // namespace

Bytes encode(const ScanTelegram& telegram) {
  SCANBED_ENSURE(telegram.words.size() <= 401 && telegram.partial >= 0 && telegram.partial <= 3);
  Bytes body{kMeasuredValues};
  append_word(body, header_of(telegram));
  for (const std::uint16_t word : telegram.words) append_word(body, word);
  if (telegram.indices) {
    body.push_back(telegram.indices->scan);
    body.push_back(telegram.indices->telegram);
  }
  body.push_back(telegram.status.bits);
  return body;
}

bool parse_scan(ByteView body, ScanTelegram& telegram) {
  if (body.size() < kWordsAt + 1 || body[0] != kMeasuredValues) return false;
  const unsigned header = read_word(body, 1);
  const std::size_t num_words = header & kCountMask;
  const unsigned unit = header >> kUnitShift;
  const std::size_t bare = 2 * num_words + kWordsAt + 1;
  if (unit > 1 || (header & kReservedBit) != 0 || (body.size() != bare && body.size() != bare + 2))
    return false;
  telegram.unit = unit == 1 ? RangeUnit::kMillimetre : RangeUnit::kCentimetre;
  telegram.is_partial = (header & kPartialFlag) != 0;
  telegram.partial = static_cast<int>((header >> kPartialShift) & 3U);
  telegram.words.resize(num_words);
  const std::uint8_t* bytes = body.data() + kWordsAt;
  for (std::size_t i = 0; i < num_words; ++i) {
    telegram.words[i] = static_cast<std::uint16_t>(bytes[2 * i] | (bytes[2 * i + 1] << 8));
  }
  telegram.indices.reset();
  if (body.size() != bare) telegram.indices = {{body[bare - 1], body[bare]}};
  telegram.status.bits = body.back();
  return true;
}

bool matches(const ScanTelegram& telegram, const ScanExpectation& expected) {
  const int num_words = static_cast<int>(telegram.words.size());
  const int wanted = expected.is_partial ? partial_size(telegram.partial) : expected.variant.num_beams();
  return num_words == wanted && telegram.unit == expected.unit &&
         telegram.is_partial == expected.is_partial && (telegram.is_partial || telegram.partial == 0) &&
         telegram.indices.has_value() == expected.has_indices;
}

}  // namespace scanbed::hw
