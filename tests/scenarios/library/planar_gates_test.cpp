// SPDX-License-Identifier: MIT
#include "tests/scenarios/library/library_run.hpp"

namespace scanbed::scenarios {
namespace {

class PlanarGatesTest : public ::testing::TestWithParam<std::string> {};

TEST_P(PlanarGatesTest, AreMetByBothPresets) {
  testing::expect_gates_met(GetParam(), sim::Backend::kPlanar);
}

INSTANTIATE_TEST_SUITE_P(Library, PlanarGatesTest, ::testing::ValuesIn(testing::all_scenarios()),
                         testing::name_of);

}  // namespace
}  // namespace scanbed::scenarios
