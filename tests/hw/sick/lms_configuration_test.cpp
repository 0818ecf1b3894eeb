// SPDX-License-Identifier: MIT
#include "hw/sick/lms_configuration.hpp"

#include <gtest/gtest.h>

#include "tests/support/hex.hpp"

namespace scanbed::hw {
namespace {

using tests::from_hex;

TEST(LmsConfigurationTest, DefaultsToMillimetresInMode00) {
  const LmsConfiguration configuration;
  EXPECT_EQ(configuration.bytes().size(), 34U);
  EXPECT_EQ(configuration.unit(), RangeUnit::kMillimetre);
  EXPECT_EQ(configuration.measuring_mode(), 0);
  EXPECT_FALSE(configuration.sends_indices());
}

TEST(LmsConfigurationTest, ChangesNoByteBesideTheOneThatIsSet) {
  LmsConfiguration configuration;
  const Bytes before(configuration.bytes().begin(), configuration.bytes().end());
  configuration.set_unit(RangeUnit::kCentimetre);
  configuration.set_measuring_mode(6);
  configuration.set_availability(2);
  EXPECT_TRUE(configuration.is_centimetre());
  EXPECT_TRUE(configuration.sends_indices());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool is_set = i >= 4 && i <= 6;
    EXPECT_EQ(configuration.bytes()[i] != before[i], is_set) << i;
  }
}

TEST(LmsConfigurationTest, KeepsUnknownBytesAndBothLengths) {
  for (const std::size_t size : {32U, 34U, 36U, 64U}) {
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i + 100);
    const auto configuration = LmsConfiguration::from_bytes(bytes);
    ASSERT_TRUE(configuration.has_value());
    EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), configuration->bytes().begin()));
  }
}

TEST(LmsConfigurationTest, RefusesOtherLengths) {
  for (const std::size_t size : {0U, 31U, 65U}) {
    EXPECT_FALSE(LmsConfiguration::from_bytes(Bytes(size)).has_value()) << size;
  }
}

}  // namespace
}  // namespace scanbed::hw
