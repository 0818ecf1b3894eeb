// SPDX-License-Identifier: MIT
#include "scenarios/run/emulation.hpp"

#include <gtest/gtest.h>

#include "hw/sick/sick_lms.hpp"
#include "scenarios/load/library.hpp"
#include "scenarios/load/load_scenario.hpp"
#include "sim/sensor/simulated_lms.hpp"
#include "tests/support/running_emulator.hpp"

namespace scanbed::scenarios {
namespace {

Scenario hallway() {
  return load_scenario(find_scenario("static_hallway"), {});
}

TEST(EmulationTest, ComesUpAsTheScenariosSensor) {
  Scenario scenario = hallway();
  EXPECT_EQ(emulator_options(scenario).variant, (hw::LmsVariant{180, 50}));
  scenario.lms.fov_rad = radians(100.0);
  scenario.lms.step_rad = radians(0.25);
  scenario.lms.unit = RangeUnit::kCentimetre;
  EXPECT_EQ(emulator_options(scenario).variant, (hw::LmsVariant{100, 25}));
  EXPECT_TRUE(emulator_options(scenario).configuration.is_centimetre());
}

TEST(EmulationTest, TellsOfASensorThatIsNoLms) {
  Scenario scenario = hallway();
  EXPECT_FALSE(unlike_an_lms(scenario));
  scenario.lms.step_rad = radians(0.25);
  EXPECT_EQ(unlike_an_lms(scenario),
            "no LMS 2xx sees 180 degrees in steps of 0.25; the emulated one begins with 180 and 0.5");
}

// Scans that come as fast as a turn of the mirror, and a host that wants steps which take four.
TEST(EmulationTest, GivesFinerStepsThanTheScenariosPeriodHasTimeFor) {
  Scenario scenario = hallway();
  scenario.lms.scan_period_s = 2.0 * scenario.lms.rotation_s;
  const auto source = scenario_scans(scenario, sim::Backend::kPlanar);
  LaserScan scan;
  EXPECT_TRUE(source({{100, 25}, RangeUnit::kMillimetre})->next(scan, {}));
  EXPECT_EQ(scan.num_beams(), 401);
}

TEST(EmulationTest, GivesWhatTheHostConfigures) {
  const auto source = scenario_scans(hallway(), sim::Backend::kPlanar);
  LaserScan scan;
  EXPECT_TRUE(source({{180, 25}, RangeUnit::kMillimetre})->next(scan, {}));
  EXPECT_EQ(scan.num_beams(), 721);
  EXPECT_TRUE(source({{100, 100}, RangeUnit::kCentimetre})->next(scan, {}));
  EXPECT_EQ(scan.num_beams(), 101);
}

// In process, and by way of telegrams, a port and the driver: the same scans.
TEST(EmulationTest, TheWireChangesNothing) {
  const Scenario scenario = hallway();
  hw::EmulatorOptions options = emulator_options(scenario);
  options.is_paced = false;
  options.power_on_baud = 500000;
  tests::RunningEmulator emulator(options, scenario_scans(scenario, sim::Backend::kPlanar));
  hw::SickLms laser(tests::patient_driver(emulator.port()));
  sim::SimulatedLms simulated(
      scenario.world, {.lms = scenario.lms, .duration_s = scenario.duration_s, .seed = scenario.seed});
  LaserScan expected;
  LaserScan got;
  for (int i = 0; i < 50; ++i) {
    ASSERT_TRUE(simulated.next(expected, {}));
    ASSERT_TRUE(laser.next(got, RangeSensor::Seconds(60.0)));
    ASSERT_EQ(got.num_beams(), expected.num_beams());
    for (int beam = 0; beam < got.num_beams(); ++beam) {
      const double a = got.range_m[static_cast<std::size_t>(beam)];
      const double b = expected.range_m[static_cast<std::size_t>(beam)];
      ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << "scan " << i << " beam " << beam;
    }
  }
}

}  // namespace
}  // namespace scanbed::scenarios
