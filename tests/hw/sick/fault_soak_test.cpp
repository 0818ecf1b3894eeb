// SPDX-License-Identifier: MIT
#include "tests/hw/sick/soak.hpp"

namespace scanbed::hw {
namespace {

TEST(FaultSoakTest, EveryScanIsTrueThroughAHundredFaults) {
  tests::expect_to_survive(100, 1);
}

}  // namespace
}  // namespace scanbed::hw
