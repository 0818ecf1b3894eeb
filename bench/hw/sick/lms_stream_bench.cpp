// SPDX-License-Identifier: MIT
// What the driver computes for each scan of an LMS: bytes of the wire to metres.
#include <benchmark/benchmark.h>

#include "core/errors/ensure.hpp"
#include "hw/sick/crc.hpp"
#include "hw/sick/scan_assembler.hpp"
#include "hw/sick/telegram_decoder.hpp"

namespace scanbed::hw {
namespace {

/// A telegram of 361 values: 732 bytes.
Bytes telegram_of_361() {
  ScanTelegram telegram;
  for (int i = 0; i < 361; ++i) telegram.words.push_back(static_cast<std::uint16_t>((i * 37) % 8000));
  return frame_telegram(0x80, encode(telegram));
}

void check_word_of_732_bytes(benchmark::State& state) {
  const Bytes bytes = telegram_of_361();
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(lms_crc(bytes));
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes.size()));
}
BENCHMARK(check_word_of_732_bytes);

void telegram_of_732_bytes_to_scan(benchmark::State& state) {
  const Bytes bytes = telegram_of_361();
  TelegramDecoder decoder(TelegramDecoder::Talker::kSensor);
  ScanAssembler assembler({}, {}, false);
  LaserScan scan;
  WireItem item;
  for ([[maybe_unused]] auto _ : state) {
    decoder.feed(bytes, 0.0);
    SCANBED_ENSURE(decoder.next(item));
    SCANBED_ENSURE(assembler.take(item.body, {1.0}, scan) == ScanAssembler::Outcome::kScan);
    benchmark::DoNotOptimize(scan.range_m.data());
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(telegram_of_732_bytes_to_scan);

// As an adapter gives them: 62 bytes at a time.
void telegram_in_pieces_to_scan(benchmark::State& state) {
  const Bytes bytes = telegram_of_361();
  TelegramDecoder decoder(TelegramDecoder::Talker::kSensor);
  ScanAssembler assembler({}, {}, false);
  LaserScan scan;
  WireItem item;
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t at = 0; at < bytes.size(); at += 62) {
      decoder.feed(ByteView(bytes).subspan(at, std::min<std::size_t>(62, bytes.size() - at)), 0.0);
      if (decoder.next(item)) assembler.take(item.body, {1.0}, scan);
    }
    benchmark::DoNotOptimize(scan.range_m.data());
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(telegram_in_pieces_to_scan);

}  // namespace
}  // namespace scanbed::hw

BENCHMARK_MAIN();
