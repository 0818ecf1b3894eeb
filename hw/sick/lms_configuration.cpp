// SPDX-License-Identifier: MIT
#include "hw/sick/lms_configuration.hpp"

namespace scanbed::hw {
namespace {

constexpr std::size_t kFewestBytes = 32;
constexpr std::size_t kMostBytes = 64;

}  // namespace

LmsConfiguration::LmsConfiguration()
    : bytes_{0x00, 0x00, 0x46, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x02, 0x02, 0x00,
             0x00, 0x00, 0x0A, 0x0A, 0x50, 0x64, 0x00, 0x0A, 0x0A, 0x50, 0x64, 0x00,
             0x0A, 0x0A, 0x50, 0x64, 0x00, 0x00, 0x00, 0x00, 0x02, 0x00} {}

std::optional<LmsConfiguration> LmsConfiguration::from_bytes(ByteView bytes) {
  if (bytes.size() < kFewestBytes || bytes.size() > kMostBytes) return std::nullopt;
  LmsConfiguration configuration;
  configuration.bytes_.assign(bytes.begin(), bytes.end());
  return configuration;
}

}  // namespace scanbed::hw
