// SPDX-License-Identifier: MIT
// Any bytes are telegrams of a sensor and of a host, or garbage: whatever is found has a true check word, and
// no scan is made of what was not configured.
#include <cmath>

#include "core/errors/ensure.hpp"
#include "hw/sick/crc.hpp"
#include "hw/sick/lms_command.hpp"
#include "hw/sick/lms_reply.hpp"
#include "hw/sick/scan_assembler.hpp"
#include "hw/sick/telegram_decoder.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace {

using namespace scanbed;
using namespace scanbed::hw;

void check_scan(ScanAssembler& assembler, ByteView body) {
  LaserScan scan;
  if (assembler.take(body, {1.0}, scan) != ScanAssembler::Outcome::kScan) return;
  SCANBED_ENSURE(scan.num_beams() == assembler.geometry().num_beams);
  for (const double range_m : scan.range_m) {
    SCANBED_ENSURE(!std::isfinite(range_m) || (range_m >= 0.0 && range_m <= scan.geometry.max_range_m));
  }
}

void check(TelegramDecoder::Talker talker, ByteView bytes) {
  TelegramDecoder decoder(talker);
  ScanAssembler whole({}, {}, false);
  SickOptions interlaced;
  interlaced.resolution_cdeg = 25;
  ScanAssembler turns(interlaced, {}, false);
  WireItem item;
  const auto take = [&] {
    while (decoder.next(item)) {
      if (item.kind != WireItem::Kind::kTelegram) continue;
      SCANBED_ENSURE(!item.body.empty() && item.body.size() <= kMaxBodyBytes);
      if (const auto command = parse_command(item.body)) SCANBED_ENSURE(!encode(*command).empty());
      if (const auto reply = parse_reply(item.body))
        SCANBED_ENSURE(!encode(reply->reply, reply->status).empty());
      check_scan(whole, item.body);
      check_scan(turns, item.body);
    }
  };
  // In two pieces, so that the seam is tried as well.
  decoder.feed(bytes.first(bytes.size() / 2), 0.0);
  take();
  decoder.feed(bytes.subspan(bytes.size() / 2), 0.01);
  take();
  for (double now_s = 1.0; decoder.is_waiting(); now_s += 1.0) {
    decoder.expire(now_s);
    take();
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 8192) return 0;  // each byte may be looked at as a start: longer inputs are slow, not new
  check(TelegramDecoder::Talker::kSensor, {data, size});
  check(TelegramDecoder::Talker::kHost, {data, size});
  // Bodies, without the check word to guess.
  parse_command({data, size});
  parse_reply({data, size});
  ScanTelegram telegram;
  parse_scan({data, size}, telegram);
  return 0;
}
