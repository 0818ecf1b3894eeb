// SPDX-License-Identifier: MIT
#include "tests/scenarios/library/library_run.hpp"

namespace scanbed::scenarios {
namespace {

class SpatialGatesTest : public ::testing::TestWithParam<std::string> {};

TEST_P(SpatialGatesTest, AreMetByBothPresets) {
  testing::expect_gates_met(GetParam(), sim::Backend::kSpatial);
}

INSTANTIATE_TEST_SUITE_P(Library, SpatialGatesTest, ::testing::ValuesIn(testing::all_scenarios()),
                         testing::name_of);

}  // namespace
}  // namespace scanbed::scenarios
