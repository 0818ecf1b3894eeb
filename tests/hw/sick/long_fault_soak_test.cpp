// SPDX-License-Identifier: MIT
#include "tests/hw/sick/soak.hpp"

namespace scanbed::hw {
namespace {

TEST(LongFaultSoakTest, EveryScanIsTrueThroughTenThousandFaults) {
  tests::expect_to_survive(10000, 2);
}

}  // namespace
}  // namespace scanbed::hw
