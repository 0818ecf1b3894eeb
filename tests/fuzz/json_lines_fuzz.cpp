// SPDX-License-Identifier: MIT
// Any bytes are a recording of ours, or an InputError.
#include "hw/recording/json_lines.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/recording_fuzz.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  scanbed::fuzz::read_any(data, size, [](auto bytes, const char* name, auto report) {
    return scanbed::hw::read_json_lines(std::move(bytes), name, {}, report);
  });
  return 0;
}
