// SPDX-License-Identifier: MIT
#include "hw/sick/telegram_decoder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/hex.hpp"

namespace scanbed::hw {
namespace {

using tests::from_hex;
using Talker = TelegramDecoder::Talker;

/// The bodies of all telegrams, in order.
std::vector<Bytes> decode(ByteView bytes, Talker talker = Talker::kSensor) {
  TelegramDecoder decoder(talker);
  decoder.feed(bytes, 0.0);
  std::vector<Bytes> found;
  for (WireItem item; decoder.next(item);) {
    if (item.kind == WireItem::Kind::kTelegram) found.emplace_back(item.body.begin(), item.body.end());
  }
  return found;
}

Bytes join(std::initializer_list<Bytes> parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

const Bytes kDoneTelegram = from_hex("02 80 03 00 A0 00 10 16 0A");
const Bytes kDoneBody = from_hex("A0 00 10");

TEST(TelegramDecoderTest, FindsAcknowledgementAndReply) {
  TelegramDecoder decoder(Talker::kSensor);
  decoder.feed(join({{kAcknowledge}, kDoneTelegram, {kNotAcknowledge}}), 0.0);
  WireItem item;
  ASSERT_TRUE(decoder.next(item));
  EXPECT_EQ(item.kind, WireItem::Kind::kAckByte);
  ASSERT_TRUE(decoder.next(item));
  EXPECT_EQ(item.kind, WireItem::Kind::kTelegram);
  EXPECT_EQ(item.address, 0x80);
  EXPECT_EQ(Bytes(item.body.begin(), item.body.end()), kDoneBody);
  EXPECT_EQ(item.num_bytes_behind, 1U);
  ASSERT_TRUE(decoder.next(item));
  EXPECT_EQ(item.kind, WireItem::Kind::kNakByte);
  EXPECT_FALSE(decoder.next(item));
}

TEST(TelegramDecoderTest, TakesBothReplyAddresses) {
  EXPECT_EQ(decode(from_hex("02 81 03 00 A0 00 10 36 1A")).size(), 1U);
}

TEST(TelegramDecoderTest, TakesBytesOneByOne) {
  TelegramDecoder decoder(Talker::kSensor);
  WireItem item;
  for (std::size_t i = 0; i < kDoneTelegram.size(); ++i) {
    EXPECT_FALSE(decoder.next(item));
    decoder.feed(ByteView(kDoneTelegram).subspan(i, 1), 0.01 * static_cast<double>(i));
  }
  EXPECT_TRUE(decoder.next(item));
}

TEST(TelegramDecoderTest, FindsATelegramInsideWhatLookedLikeOne) {
  // A start of a telegram of 5 bytes, cut off by a whole one.
  EXPECT_EQ(decode(join({from_hex("02 80 05 00 A0"), kDoneTelegram})), std::vector<Bytes>{kDoneBody});
  // The same behind a start byte, and behind garbage that holds several.
  EXPECT_EQ(decode(join({{0x02}, kDoneTelegram})), std::vector<Bytes>{kDoneBody});
  EXPECT_EQ(decode(join({from_hex("FF 02 02 80 02 80 01 00 00 02"), kDoneTelegram})),
            std::vector<Bytes>{kDoneBody});
}

TEST(TelegramDecoderTest, DropsWhatItsCheckWordRefuses) {
  Bytes damaged = kDoneTelegram;
  damaged[5] ^= 0x10;
  TelegramDecoder decoder(Talker::kSensor);
  decoder.feed(join({damaged, kDoneTelegram}), 0.0);
  WireItem item;
  int num_telegrams = 0;
  while (decoder.next(item)) num_telegrams += item.kind == WireItem::Kind::kTelegram ? 1 : 0;
  EXPECT_EQ(num_telegrams, 1);
  EXPECT_GE(decoder.counts().num_crc_errors, 1);
  EXPECT_GE(decoder.counts().num_garbage_bytes, 8);
}

TEST(TelegramDecoderTest, RefusesLengthsBeyondTheLongestTelegram) {
  // 0x0329 = 809.
  EXPECT_EQ(decode(join({from_hex("02 80 29 03 B0"), kDoneTelegram})).size(), 1U);
  EXPECT_EQ(decode(join({from_hex("02 80 00 00 B0"), kDoneTelegram})).size(), 1U);
}

TEST(TelegramDecoderTest, HostAndSensorDoNotMistakeTheirOwnEcho) {
  const Bytes request = from_hex("02 00 01 00 31 15 12");
  EXPECT_TRUE(decode(request, Talker::kSensor).empty());
  EXPECT_EQ(decode(request, Talker::kHost).size(), 1U);
  EXPECT_TRUE(decode(kDoneTelegram, Talker::kHost).empty());
}

TEST(TelegramDecoderTest, GivesUpATelegramWhoseRestStaysAway) {
  TelegramDecoder decoder(Talker::kSensor);
  decoder.feed(join({from_hex("02 80 D6 02 B0 69 41"), kDoneTelegram}), 1.0);
  WireItem item;
  EXPECT_FALSE(decoder.next(item));
  decoder.expire(1.0 + 0.9 * TelegramDecoder::kExpiry_s);
  EXPECT_FALSE(decoder.next(item));
  decoder.expire(1.0 + 1.01 * TelegramDecoder::kExpiry_s);
  ASSERT_TRUE(decoder.next(item));
  EXPECT_EQ(item.kind, WireItem::Kind::kTelegram);
  EXPECT_EQ(decoder.counts().num_expired, 1);
  EXPECT_FALSE(decoder.is_waiting());
}

TEST(TelegramDecoderTest, ClearForgetsHalfATelegram) {
  TelegramDecoder decoder(Talker::kSensor);
  decoder.feed(from_hex("02 80 03 00 A0"), 0.0);
  decoder.clear();
  decoder.feed(kDoneTelegram, 0.0);
  WireItem item;
  EXPECT_TRUE(decoder.next(item));
}

// Whatever stands before it, cut wherever: the telegram behind is found once the false starts are given up.
RC_GTEST_PROP(TelegramDecoderTest, FindsTheTelegramBehindAnyGarbage, (const Bytes& garbage)) {
  const std::size_t cut = *rc::gen::inRange<std::size_t>(0, garbage.size() + kDoneTelegram.size() + 1);
  const Bytes all = join({garbage, kDoneTelegram});
  TelegramDecoder decoder(Talker::kSensor);
  decoder.feed(ByteView(all).first(cut), 0.0);
  Bytes last;
  const auto take = [&] {
    for (WireItem item; decoder.next(item);) {
      if (item.kind == WireItem::Kind::kTelegram) last.assign(item.body.begin(), item.body.end());
    }
  };
  take();
  decoder.feed(ByteView(all).subspan(cut), 0.01);
  take();
  while (decoder.is_waiting()) {
    decoder.expire(1.0);
    take();
  }
  RC_ASSERT(last == kDoneBody);
}

TEST(TelegramDecoderTest, WaitsForTheRestAsLongAsItIsTold) {
  TelegramDecoder decoder(Talker::kSensor);
  decoder.set_expiry(1.0);
  WireItem item;
  decoder.feed(ByteView(kDoneTelegram).first(5), 0.0);
  EXPECT_FALSE(decoder.next(item));
  decoder.expire(0.9);
  decoder.feed(ByteView(kDoneTelegram).subspan(5), 0.9);
  EXPECT_TRUE(decoder.next(item));
  decoder.feed(ByteView(kDoneTelegram).first(5), 1.0);
  EXPECT_FALSE(decoder.next(item));
  decoder.expire(2.0);
  EXPECT_EQ(decoder.counts().num_expired, 1);
}

TEST(TelegramDecoderTest, KnowsHowMuchOfATelegramIsMissing) {
  TelegramDecoder decoder(Talker::kSensor);
  WireItem item;
  for (std::size_t i = 0; i < kDoneTelegram.size(); ++i) {
    // The length is known once it is clear that this can be a telegram.
    EXPECT_EQ(decoder.num_missing(), i < 5 ? 0 : kDoneTelegram.size() - i) << i;
    decoder.feed({&kDoneTelegram[i], 1}, 0.0);
    EXPECT_EQ(decoder.next(item), i + 1 == kDoneTelegram.size());
  }
  EXPECT_EQ(decoder.num_missing(), 0U);
}

}  // namespace
}  // namespace scanbed::hw
