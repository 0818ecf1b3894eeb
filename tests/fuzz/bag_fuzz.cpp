// SPDX-License-Identifier: MIT
// Any bytes are a ROS bag, or an InputError.
#include "hw/recording/bag_reader.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/recording_fuzz.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  scanbed::fuzz::read_any(data, size, [](auto bytes, const char* name, auto report) {
    return scanbed::hw::read_bag(std::move(bytes), name, {}, report);
  });
  return 0;
}
